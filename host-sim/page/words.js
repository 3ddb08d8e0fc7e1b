// Descriptions and remedies of error numbers, loaded from the server's table of errors and alarms.

let words = { errors: {} };

export async function loadWords() { words = await (await fetch('words')).json(); }

// Returns an answer of the controller. Adds the description and the remedy to an error.
export function answerWords(line) {
  const number = /^error:(\d+)/.exec(line)?.[1];
  return words.errors[number] ? `${line}  (${words.errors[number]})` : line;
}
