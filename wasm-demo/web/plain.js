// Objects of the module as objects of JavaScript.

/** An object of the module as one of JavaScript, so that it need not be freed. */
export function plain(object) {
  const names = Object.getOwnPropertyNames(Object.getPrototypeOf(object));
  const fields = names.filter((name) => name !== "constructor" && typeof object[name] !== "function");
  const copy = Object.fromEntries(fields.map((name) => [name, object[name]]));
  object.free();
  return copy;
}
