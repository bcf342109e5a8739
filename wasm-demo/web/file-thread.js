// Asks the worker that reads files.

/**
 * A file to read, the throw of its lights in metres, and whether they are taken as round; or a light of the last file, and a tool
 * whose parameters are asked, or nothing more for the pictures of one that is not round.
 * @typedef {{ name: string, bytes: Uint8Array<ArrayBuffer>, reach: number, isRound: boolean } | { light: number, tool?: string }} Question
 */

export class FileThread {
  /** @type {Worker | undefined} */
  #worker;
  #number = 0;
  #isReading = false;
  /** @type {{ resolve: (answer: any) => void, reject: (cause: unknown) => void }} */
  #asker = { resolve() {}, reject() {} };

  /**
   * Answers a question, or rejects with a refusal, which is a string, or with an error. A later question replaces it: the promise is
   * then never settled. A file that another one replaces is not read to its end; while a file is read, a question about the one
   * before it has no answer.
   * @param {Question} question
   * @returns {Promise<any>}
   */
  ask(question) {
    const isFile = "bytes" in question;
    if (this.#isReading && !isFile) return new Promise(() => {});
    if (this.#isReading) this.#end();
    const worker = (this.#worker ??= this.#start());
    this.#isReading = isFile;
    this.#number += 1;
    worker.postMessage({ number: this.#number, question }, isFile ? [question.bytes.buffer] : []);
    return new Promise((resolve, reject) => (this.#asker = { resolve, reject }));
  }

  #start() {
    const worker = new Worker(new URL("file-worker.js", import.meta.url), { type: "module" });
    worker.onmessage = ({ data: { number, answer, refusal, failure } }) => {
      if (number !== this.#number) return;
      this.#isReading = false;
      if (failure === undefined) return refusal === undefined ? this.#asker.resolve(answer) : this.#asker.reject(refusal);
      this.#fail(`The file could not be read: ${failure}`);
    };
    worker.onerror = (event) => this.#fail(`What reads files could not be loaded: ${event.message ?? "no module workers"}`);
    return worker;
  }

  /**
   * Begins anew with the next file: a module that has trapped can't be called any more.
   * @param {string} text
   */
  #fail(text) {
    this.#end();
    this.#asker.reject(new Error(text));
  }

  #end() {
    this.#worker?.terminate();
    this.#worker = undefined;
    this.#isReading = false;
  }
}
