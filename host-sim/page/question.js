// A question that has to be answered before something happens.

const at = (id) => document.getElementById(id);

// Resolves with true for `yes`, with false for anything else.
export function ask(title, lines, yes) {
  const dialog = at('question');
  at('question-title').textContent = title;
  at('question-lines').replaceChildren(...lines.map((line) => {
    const item = document.createElement('li');
    item.textContent = line;
    return item;
  }));
  at('question-yes').textContent = yes;
  dialog.returnValue = 'no';
  dialog.showModal();
  at('question-no').focus();
  return new Promise((resolve) => {
    dialog.onclose = () => resolve(dialog.returnValue === 'yes');
  });
}
