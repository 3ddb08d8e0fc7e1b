// Reads the record of `kerfline serve --record`: all bytes that the controller received.

import fs from 'node:fs';

const kEscapes = { n: '\n', r: '\r', t: '\t', '"': '"', '\\': '\\' };

const unescape = (text) =>
  text.replace(/\\(x([0-9A-Fa-f]{2})|.)/g, (_, code, hex) =>
    hex ? String.fromCharCode(parseInt(hex, 16)) : kEscapes[code],
  );

/// Returns all bytes from the sender, one character each.
export function bytesReceived(file) {
  const heard = fs.readFileSync(file, 'latin1').matchAll(/^> \d+ "(.*)"$/gm);
  return [...heard].map(([, text]) => unescape(text)).join('');
}

/// Returns the lines from the sender, without empty lines and realtime bytes (raw or as UTF-8).
export function linesReceived(file) {
  const text = bytesReceived(file).replace(/\xC2[\x80-\xBF]|[\x18?!~\x80-\xBF]/g, '');
  return text.split(/\r\n|\r|\n/).filter(Boolean);
}
