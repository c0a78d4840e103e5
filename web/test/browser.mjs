// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// A page in headless Chromium, driven by its protocol over two pipes.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { createReadStream, existsSync, mkdtempSync, rmSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { extname, join, normalize, resolve } from 'node:path';

const TYPES = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.mjs': 'text/javascript',
  '.css': 'text/css',
  '.wasm': 'application/wasm',
};

/** A server of the files in `folder`, on this machine alone, and its address. `served` gets the names of those asked for. */
function serve(folder, served) {
  const server = createServer((request, response) => {
    served.add(new URL(request.url, 'http://localhost').pathname.slice(1));
    const path = join(folder, normalize(new URL(request.url, 'http://localhost').pathname));
    const file = path.endsWith('/') ? join(path, 'index.html') : path;
    if (!file.startsWith(folder) || !existsSync(file)) return response.writeHead(404).end();
    response.writeHead(200, { 'content-type': TYPES[extname(file)] ?? 'application/octet-stream' });
    createReadStream(file).pipe(response);
  });
  return new Promise((done) =>
    server.listen(0, '127.0.0.1', () =>
      done({ server, address: `http://127.0.0.1:${server.address().port}/` }),
    ),
  );
}

export class Page {
  /** What the page wrote as errors, and what it threw. */
  errors = [];
  /** The names of the files that it was served. */
  served = new Set();
  #next = 1;
  #waiting = new Map();
  #rest = '';

  /** Serves `folder` and opens its file `path`; a `folder` that is an address is opened. `script` runs in the page before its own. */
  static async open(program, folder, { path = '', width = 1280, height = 1100, script = '' } = {}) {
    const page = new Page();
    const { server, address } = folder.startsWith('http:')
      ? { address: folder }
      : await serve(resolve(folder), page.served);
    page.server = server;
    page.profile = mkdtempSync(join(tmpdir(), 'clipc-browser-'));
    const options = [
      '--headless=new',
      '--no-sandbox',
      '--remote-debugging-pipe',
      '--enable-unsafe-swiftshader',
      '--use-angle=swiftshader',
      `--user-data-dir=${page.profile}`,
      `--window-size=${width},${height}`,
      '--no-first-run',
      'about:blank',
    ];
    page.process = spawn(program, options, {
      stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'],
    });
    page.process.stdio[4].setEncoding('utf8').on('data', (data) => page.#receive(data));
    const { targetId } = await page.#send('Target.createTarget', { url: 'about:blank' });
    ({ sessionId: page.session } = await page.#send('Target.attachToTarget', {
      targetId,
      flatten: true,
    }));
    for (const domain of ['Page', 'Runtime', 'Log']) await page.send(`${domain}.enable`);
    if (script) await page.send('Page.addScriptToEvaluateOnNewDocument', { source: script });
    await page.send('Page.navigate', { url: address + path });
    return page;
  }

  send(method, params = {}) {
    return this.#send(method, params, this.session);
  }

  /** The processor time that the page's process has taken, its workers with it: seconds. */
  async processorTime() {
    const { processInfo } = await this.#send('SystemInfo.getProcessInfo');
    return Math.max(
      0,
      ...processInfo.filter(({ type }) => type === 'renderer').map(({ cpuTime }) => cpuTime),
    );
  }

  /** The value of an expression, or of what it promises. */
  async evaluate(expression) {
    const { result, exceptionDetails } = await this.send('Runtime.evaluate', {
      expression,
      awaitPromise: true,
      returnByValue: true,
    });
    if (exceptionDetails)
      throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  /** Waits until an expression is true. */
  async until(expression, milliseconds = 60000) {
    for (
      const end = Date.now() + milliseconds;
      Date.now() < end;
      await new Promise((done) => setTimeout(done, 50))
    ) {
      if (await this.evaluate(expression)) return;
    }
    throw new Error(`still not: ${expression}`);
  }

  /** Waits until the page is loaded, and until a condition of its own is true. */
  loaded(condition = 'true') {
    return this.until(
      `location.protocol === "http:" && document.readyState === "complete" && (${condition})`,
    );
  }

  /** Gives the control `id` a value, as a person does. */
  set(id, value) {
    return this
      .evaluate(`(() => { const control = document.getElementById('${id}'); control.value = ${JSON.stringify(value)};
      control.dispatchEvent(new Event('input')); })()`);
  }

  /** Runs a part of a test. Where it throws, or the page writes an error, that is printed, and the program's status is 1. */
  async test(name, run) {
    try {
      await run();
      assert.deepEqual(this.errors, []);
      console.log(`ok ${name}`);
    } catch (error) {
      process.exitCode = 1;
      this.errors.length = 0;
      console.log(`FAILED ${name}: ${error.message}`);
    }
  }

  async close() {
    this.server?.close();
    const ended = new Promise((done) => this.process.once('exit', done));
    this.#send('Browser.close');
    await ended;
    // The browser's other processes end after its first one, and write into the profile until then.
    for (let tries = 100; tries > 0; --tries) {
      try {
        return rmSync(this.profile, { recursive: true, force: true });
      } catch (error) {
        if (error.code !== 'ENOTEMPTY' || tries === 1) throw error;
      }
      await new Promise((done) => setTimeout(done, 100));
    }
  }

  #send(method, params = {}, sessionId) {
    const id = this.#next++;
    this.process.stdio[3].write(JSON.stringify({ id, method, params, sessionId }) + '\0');
    return new Promise((resolve, reject) => this.#waiting.set(id, { resolve, reject }));
  }

  #receive(data) {
    const messages = (this.#rest + data).split('\0');
    this.#rest = messages.pop();
    for (const { id, result, error, method, params } of messages.map((text) => JSON.parse(text))) {
      if (id) {
        const { resolve, reject } = this.#waiting.get(id);
        this.#waiting.delete(id);
        if (error) reject(new Error(error.message));
        else resolve(result);
      } else if (method === 'Runtime.exceptionThrown') {
        this.errors.push(
          params.exceptionDetails.exception?.description ?? params.exceptionDetails.text,
        );
      } else if (method === 'Runtime.consoleAPICalled' && params.type === 'error') {
        this.errors.push(params.args.map((arg) => arg.value ?? arg.description).join(' '));
      } else if (method === 'Log.entryAdded' && params.entry.level === 'error') {
        this.errors.push(params.entry.text);
      }
    }
  }
}
