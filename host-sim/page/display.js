// Displays of the machine's numbers next to the canvas.

const kAxes = ['X', 'Y', 'Z'];
const kWays = {
  pty: 'a sender on the serial port', tcp: 'a sender over TCP', ws: 'a sender over WebSocket',
  can: 'a sender on the CAN bus', slcan: 'a sender on the CAN bus', page: 'another page',
};

const at = (id) => document.getElementById(id);

function set(id, text) {
  if (at(id).textContent !== text) at(id).textContent = text;
}

function rowOf(axis) {
  let row = at('places').rows[axis];
  if (row) return row;
  row = at('places').insertRow();
  for (let cell = 0; cell < 4; ++cell) row.insertCell();
  row.cells[0].textContent = kAxes[axis];
  return row;
}

function showPlaces(news) {
  kAxes.forEach((_, axis) => {
    const cells = rowOf(axis).cells;
    cells[1].textContent = (news.mpos[axis] - news.wco[axis]).toFixed(3);
    cells[2].textContent = news.mpos[axis].toFixed(3);
    const homed = (news.homed >> axis & 1) === 1;
    cells[3].textContent = homed ? '⌂' : '';
    cells[3].title = homed ? 'homed' : '';
  });
}

// Shows an override. A slider that the operator is moving keeps its position.
function showOverride(id, output, percent) {
  if (document.activeElement !== at(id) || at(id).disabled) at(id).value = percent;
  set(output, `${percent} %`);
}

function owner(news, controls) {
  if (controls) return 'You control the machine';
  if (news.sender === 'job') return 'A job runs without an operator';
  return news.sender ? `Controlled by ${kWays[news.sender] ?? news.sender}` : 'Not controlled';
}

function showJob(job) {
  const counted = ['running', 'stopped', 'done'].includes(job.state);
  const at = job.state === 'stopped' && job.line > 0 ? `, stopped at line ${job.line}` : job.state === 'done' ? ', done' : '';
  set('job-name', job.state === 'none' ? 'no job' : counted ? `${job.name}  ${job.done}/${job.count}${at}` : job.name);
  document.getElementById('progress').value = counted && job.count > 0 ? job.done / job.count : 0;
}

export function show(news, view, controls) {
  const detail = news.alarm > 0 && news.state === 'Alarm' ? ` ${news.alarm}` : '';
  set('state', news.state + detail);
  at('state').dataset.state = news.state;
  set('who', owner(news, controls));
  set('version', news.version);
  showPlaces(news);
  showJob(news.job);
  set('feed', String(news.feed));
  set('power', (news.power * 100).toFixed(0));
  set('spindle', String(news.spindle));
  at('power-meter').value = news.power;
  showOverride('feed-override', 'feed-percent', news.overrides[0]);
  showOverride('power-override', 'power-percent', news.overrides[2]);
  set('rapid-percent', `${news.overrides[1]} %`);
  set('fast', `${view.fastest.toFixed(0)} mm/s`);
}
