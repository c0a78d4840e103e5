// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// One compile at a time in a worker. A newer request replaces one that waits, and a shader that takes too long is ended with its
// worker.
import { module } from './module.js';

const MOST_MILLISECONDS = 4000;

export class Compiles {
  #worker = null;
  #running = null;
  #waiting = null;
  #number = 0;
  #timer = 0;
  #isReady = false;

  /** @param {(version: string) => void} onReady */
  constructor(onReady) {
    this.onReady = onReady;
    this.#start();
  }

  /** Resolves to {results, milliseconds}, to {stopped: true}, or never if a newer request came first. */
  compile(text, requests, includes) {
    return new Promise((resolve) => {
      this.#waiting = { text, requests, includes, resolve };
      this.#next();
    });
  }

  #start() {
    this.#isReady = false;
    this.#worker = new Worker(new URL('./worker.js', import.meta.url), { type: 'module' });
    const worker = this.#worker;
    module.then(
      (compiled) => worker.postMessage({ module: compiled }),
      (error) => this.#finish({ failed: String(error) }),
    );
    this.#worker.onmessage = ({ data }) => {
      if (data.version) {
        this.#isReady = true;
        this.onReady(data.version);
        return this.#next();
      }
      this.#finish({ results: data.results, milliseconds: data.milliseconds });
    };
    this.#worker.onerror = (event) =>
      this.#finish({ failed: event.message || 'the compiler did not load' });
  }

  #finish(answer) {
    clearTimeout(this.#timer);
    const { resolve } = this.#running ?? {};
    this.#running = null;
    resolve?.(answer);
    this.#next();
  }

  #next() {
    if (this.#running || !this.#waiting || !this.#isReady) return;
    this.#running = this.#waiting;
    this.#waiting = null;
    const { text, requests, includes } = this.#running;
    this.#worker.postMessage({ number: ++this.#number, text, requests, includes });
    this.#timer = setTimeout(() => {
      this.#worker.terminate();
      this.#start();
      this.#finish({ stopped: true });
    }, MOST_MILLISECONDS);
  }
}
