// Loading of WebAssembly modules.
import { words } from "./failure.js";

/**
 * Compiles a module at an address. The browser's own message for a failure is of little help by
 * itself.
 * @param {URL} address
 */
export async function compile(address) {
  try {
    const response = await fetch(address);
    if (!response.ok) throw new Error(`${response.status} ${response.statusText}`);
    // Browsers compile while they load, but only what the server calls by its type.
    const isTyped = response.headers.get("Content-Type") === "application/wasm";
    return await (isTyped ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer()));
  } catch (error) {
    throw new Error(
      `A WebAssembly module of the demo could not be loaded (${words(error)}). ` +
        "Serve the whole folder, pkg included, over HTTP, and reload the page.",
      { cause: error },
    );
  }
}
