// Starts CNCjs in the pinned version as a server, and uses its socket API.

import fs from 'node:fs';
import net from 'node:net';
import path from 'node:path';

import { Child, check, inSenders, load, until } from './support.mjs';

function freePort() {
  return new Promise((resolve) => {
    const server = net.createServer().listen(0, '127.0.0.1', () => {
      const { port } = server.address();
      server.close(() => resolve(port));
    });
  });
}

/// Starts CNCjs in `folder`; it offers `serialPort` to its users.
export async function startCncjs(folder, serialPort) {
  const config = path.join(folder, 'cncrc.json');
  fs.writeFileSync(
    config,
    JSON.stringify({
      ports: [{ path: serialPort, manufacturer: 'Kerfline' }],
      baudrates: [115200],
      state: { checkForUpdates: false, allowAnonymousUsageDataCollection: false },
      secret: 'for this test only',
    }),
  );
  const port = await freePort();
  const child = new Child(
    process.execPath,
    [
      inSenders('node_modules/cncjs/bin/cncjs'),
      ...['-H', '127.0.0.1', '-p', String(port), '-c', config, '--controller', 'Grbl'],
    ],
    { env: { ...process.env, HOME: folder }, cwd: folder },
  );
  child.url = `http://127.0.0.1:${port}`;
  await until('CNCjs answers', () => fetch(child.url).then((reply) => reply.ok, () => false), 30_000);
  return child;
}

/// A user of CNCjs who is connected to the controller.
export class CncjsUser {
  static async connect(cncjs, serialPort) {
    const reply = await fetch(`${cncjs.url}/api/signin`, {
      method: 'POST',
      headers: { 'content-type': 'application/json' },
      body: '{}',
    });
    const { token } = await reply.json();
    const user = new CncjsUser(load('socket.io-client')(cncjs.url, { query: `token=${token}` }));
    user.port = serialPort;
    await until('the socket is open', () => user.socket.connected);
    await new Promise((resolve, reject) =>
      user.socket.emit('open', serialPort, { controllerType: 'Grbl', baudrate: 115200 }, (error) =>
        error ? reject(error) : resolve(),
      ),
    );
    await user.state('Idle', 15_000);
    return user;
  }

  constructor(socket) {
    this.socket = socket;
    this.status = {};
    this.parser = {};
    this.read = [];
    this.written = [];
    this.sender = {};
    this.workflow = '';
    socket.on('controller:state', (type, state) => {
      this.status = state.status ?? {};
      this.parser = state.parserstate ?? {};
    });
    socket.on('serialport:read', (line) => this.read.push(line));
    socket.on('serialport:write', (line, context) => this.written.push({ line, context }));
    socket.on('sender:status', (status) => (this.sender = status));
    socket.on('workflow:state', (state) => (this.workflow = state));
  }

  command(name, ...args) {
    this.socket.emit('command', this.port, name, ...args);
  }

  /// Sends a line as if it were typed into the console.
  type(line) {
    this.command('gcode', line);
  }

  state(name, ms = 10_000) {
    return until(`state ${name}, at last ${this.status.activeState}`, () => this.status.activeState === name, ms);
  }

  load(name, text) {
    return new Promise((resolve, reject) =>
      this.command('gcode:load', name, text, {}, (error) => (error ? reject(error) : resolve())),
    );
  }

  /// Machine position of the last report, in the report's own text.
  position() {
    const { x, y, z } = this.status.mpos ?? {};
    return [x, y, z].map(Number);
  }

  refused() {
    return this.read.filter((line) => /^(error|ALARM):/.test(line));
  }

  close() {
    this.socket.emit('close', this.port, () => {});
    this.socket.close();
  }
}

export function checkNothingRefused(user) {
  check(user.refused().length === 0, `nothing was refused: ${user.refused().join(', ')}`);
}
