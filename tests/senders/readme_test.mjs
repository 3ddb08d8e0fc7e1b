// Follows the README from a clone to a moving machine in CNCjs, with every command as it is printed
// there.

import fs from 'node:fs';
import path from 'node:path';

import { Child, check, repository, run, until } from './support.mjs';
import { CncjsUser } from './cncjs.mjs';

const kHeading = '## A moving machine in CNCjs, without hardware';
const kPort = '/tmp/ttyKerfline';
const kPage = 'http://localhost:8000';

function commandsOfReadme() {
  const readme = fs.readFileSync(path.join(repository, 'README.md'), 'utf8');
  const [, section] = readme.split(kHeading);
  check(section, `the README has the section ${kHeading}`);
  return /```sh\n([\s\S]*?)```/.exec(section)[1].trim().split('\n');
}

await run('the README from clone to motion', async ({ folder, keep }) => {
  const commands = commandsOfReadme();
  check(commands.length <= 5, `at most five commands, not ${commands.length}`);
  check(commands[0].includes('<this repository>'), 'the first command clones');
  const script = commands.join('\n').replace('<this repository>', repository);
  const everything = keep(new Child('bash', ['-e', '-c', script], { cwd: folder, detached: true }));
  everything.stop = async () => {
    // The group includes the processes that it left in the background.
    process.kill(-everything.process.pid, 'SIGTERM');
    await everything.exited;
  };
  const answers = () => fetch(kPage).then((reply) => reply.ok, () => false);
  await until('CNCjs answers', async () => {
    check(everything.process.exitCode === null, `the commands go on: ${everything.output.slice(-2000)}`);
    return answers();
  }, 900_000);

  const user = await CncjsUser.connect({ url: kPage }, kPort);
  await user.load('square.nc', 'G21 G90\nG1 X20 F1200\nY20\nX0\nY0\n');
  user.command('gcode:start');
  await user.state('Run');
  await until('the machine moves', () => user.position()[0] > 1);
  await user.state('Idle', 30_000);
  user.close();
});
