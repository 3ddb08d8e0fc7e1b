// Dialog with a question that the operator must answer before an action starts.

const at = (id) => document.getElementById(id);

// Asks a question. Resolves with true if the operator clicks the button with the text `yes`,
// otherwise with false.
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
