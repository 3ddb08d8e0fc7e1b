// Keys for everything: a key presses the button of the same name, so that what
// is disabled stays so.

const kJogs = {
  ArrowLeft: 'X-1', ArrowRight: 'X1', ArrowUp: 'Y1', ArrowDown: 'Y-1', PageUp: 'Z1', PageDown: 'Z-1',
};
const kButtons = {
  c: 'control', r: 'run', x: 'reset', h: 'home', u: 'unlock', z: 'zero', Escape: 'jog-cancel', '?': 'shortcuts-button',
};

export function listenToKeys(actions) {
  document.addEventListener('keydown', (event) => {
    const target = event.target;
    const writes = target.matches('input:not([type="range"]):not([type="file"]), select, textarea');
    if (event.ctrlKey || event.metaKey || event.altKey || target.closest('dialog')) return;
    if (writes) {
      if (event.key === 'Escape') target.blur();
      return;
    }
    if (target.matches('button, a') && (event.key === ' ' || event.key === 'Enter')) return;
    if (target.matches('input[type="range"]') && event.key.startsWith('Arrow')) return;
    if (press(event.key, actions)) event.preventDefault();
  });
}

function press(key, actions) {
  const name = key.length === 1 ? key.toLowerCase() : key;
  const button = kJogs[name] ? document.querySelector(`[data-jog="${kJogs[name]}"]`)
    : document.getElementById(kButtons[name] ?? '');
  if (button) {
    button.click();
    return true;
  }
  actions[name]?.();
  return name in actions;
}
