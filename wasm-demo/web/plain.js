// Conversion of the module's objects to plain objects.

/** Copies an object of the module to a plain object that need not be freed. */
export function plain(object) {
  const names = Object.getOwnPropertyNames(Object.getPrototypeOf(object));
  const fields = names.filter((name) => name !== "constructor" && typeof object[name] !== "function");
  const copy = Object.fromEntries(fields.map((name) => [name, object[name]]));
  object.free();
  return copy;
}
