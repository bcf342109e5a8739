// Loading of WebAssembly modules.
import { words } from "./failure.js";

/**
 * Compiles a module at an address. The browser's own message for a failure is of little help by
 * itself.
 * @param {URL} address
 * @param {(bytes: number) => void} [tell] called with the number of bytes so far
 */
export async function compile(address, tell) {
  try {
    const response = await fetch(address);
    if (!response.ok) throw new Error(`${response.status} ${response.statusText}`);
    if (tell) follow(response.clone(), tell).catch(() => {});
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

/**
 * Tells how much of an answer has arrived, without what compressed it.
 * @param {Response} response
 * @param {(bytes: number) => void} tell
 */
async function follow({ body }, tell) {
  const reader = body?.getReader();
  for (let bytes = 0, part; (part = await reader?.read())?.value; tell((bytes += part.value.length)));
}
