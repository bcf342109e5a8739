// Conversion of the module's objects to plain objects.

/**
 * The fields of an object of the module, without its methods.
 * @template {{ free(): void }} T
 * @typedef {{ [K in keyof T as T[K] extends Function ? never : K]: T[K] }} Plain
 */

/**
 * Copies an object of the module to a plain object that need not be freed.
 * @template {{ free(): void }} T
 * @param {T} object
 * @returns {Plain<T>}
 */
export function plain(object) {
  const names = Object.getOwnPropertyNames(Object.getPrototypeOf(object));
  const fields = names.filter((name) => name !== "constructor" && typeof (/** @type {any} */ (object)[name]) !== "function");
  const copy = Object.fromEntries(fields.map((name) => [name, /** @type {any} */ (object)[name]]));
  object.free();
  return /** @type {any} */ (copy);
}
