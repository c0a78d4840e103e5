// SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
// The page's state in its address: JSON, deflated, in base64 for addresses.
const MOST_CHARACTERS = 1 << 20;

async function through(bytes, stream) {
  const response = new Response(new Blob([bytes]).stream().pipeThrough(stream));
  return new Uint8Array(await response.arrayBuffer());
}

export async function writeLink(state) {
  const bytes = await through(
    new TextEncoder().encode(JSON.stringify(state)),
    new CompressionStream('deflate-raw'),
  );
  const base64 = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
  return '#' + base64.replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '');
}

/** The state in the address's `hash`; null if there is none. Throws if it is damaged. */
export async function readLink(hash) {
  if (hash.length < 2) return null;
  const base64 = hash.slice(1).replace(/-/g, '+').replace(/_/g, '/');
  const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  const text = new TextDecoder().decode(
    await through(bytes, new DecompressionStream('deflate-raw')),
  );
  if (text.length > MOST_CHARACTERS) throw new RangeError('the shader in the link is too long');
  const state = JSON.parse(text);
  if (typeof state?.text !== 'string') throw new TypeError('the link has no shader');
  return state;
}
