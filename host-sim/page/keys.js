// Keyboard shortcuts. A key clicks its button, so that it has no effect if the button is disabled.
// Keys that move, stop or reset the machine, change its zero, or take or release control require
// Shift. The keys for a hold and for the end of a jog do not.

const kJogs = {
  ArrowLeft: 'X-1', ArrowRight: 'X1', ArrowUp: 'Y1', ArrowDown: 'Y-1', PageUp: 'Z1', PageDown: 'Z-1',
};
const kWithShift = {
  c: 'control', r: 'run', g: 'take-up', h: 'home', u: 'unlock', z: 'zero', x: 'reset', q: 'stop', ' ': 'resume',
};
const kAlone = { ' ': 'hold', Escape: 'jog-cancel', '?': 'shortcuts-button' };

export function listenToKeys(actions) {
  document.addEventListener('keydown', (event) => {
    const target = event.target;
    const writes = target.matches('input:not([type="range"]):not([type="file"]), select, textarea');
    if (event.ctrlKey || event.metaKey || event.altKey || target.closest('dialog')) return;
    if (writes) {
      if (event.key === 'Escape') target.blur();
      return;
    }
    if (event.repeat) return;
    if (target.matches('button, a') && event.key === 'Enter') return;
    if (target.matches('input[type="range"]') && event.key.startsWith('Arrow')) return;
    if (press(event, actions)) event.preventDefault();
  });
  // The space bar holds the machine, so it must not also click the focused button.
  document.addEventListener('keyup', (event) => {
    if (event.key === ' ' && event.target.matches('button, a')) event.preventDefault();
  });
}

function press(event, actions) {
  const name = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  const button = event.shiftKey && kJogs[name] ? document.querySelector(`[data-jog="${kJogs[name]}"]`)
    : document.getElementById((event.shiftKey && kWithShift[name]) || kAlone[name] || '');
  if (button) {
    button.click();
    return true;
  }
  actions[name]?.();
  return name in actions;
}
