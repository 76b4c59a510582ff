// Looks for the words of the box in searchIndex, [address, page, heading, text, words]
// of each section, paragraph with a run-in heading, table row and class; all words, without
// their endings, have to begin a word there. A word without a vowel before
// its ending, as spring, keeps it. A page with the title of the query comes first.
const box = document.getElementById("search");
const found = document.getElementById("found");
const escaped = (text) => text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);

function wordsOf(query) {
  return query.split(/[\s/]+/).filter(Boolean).map((word) => {
    const begin = word.length > 4 ? word.replace(/(?<=[aeiouy].*)(?<!s)(ing|ed|es|s)$/i, "") : word;
    return new RegExp("(?<![\\p{L}\\p{N}])" + begin.replace(/[.*+?^${}()|[\]\\]/g, "\\$&"), "giu");
  });
}

function score(query, words, [, page, heading, text, others]) {
  const whole = query.toLowerCase();
  const names = [heading, heading.split("/").pop(), page].map((name) => name.toLowerCase());
  let sum = 30 * names.includes(whole) + 40 * others.toLowerCase().split(", ").includes(whole);
  for (const word of words) {
    const times = (where) => (where.match(word) || []).length;
    const points = 20 * Math.min(times(heading), 1) + 10 * times(others) + 5 * times(page) + Math.min(times(text), 8);
    if (points === 0) return 0;
    sum += points;
  }
  return sum;
}

function excerpt(words, text) {
  const at = Math.max(0, text.search(words[0]) - 60);
  let part = escaped(text.slice(at, at + 220));
  for (const word of words) part = part.replace(word, "<b>$&</b>");
  return (at ? "… " : "") + part;
}

function hitsOf(query) {
  const words = wordsOf(query);
  return searchIndex.map((entry) => [score(query, words, entry), entry])
    .filter(([points]) => points > 0).sort((a, b) => b[0] - a[0]);
}

function search() {
  const query = box.value.trim();
  const words = wordsOf(query);
  found.hidden = query.length < 2;
  document.getElementById("text").hidden = !found.hidden;
  if (found.hidden) return;
  const hits = hitsOf(query);
  found.innerHTML = `<h1>${hits.length} places</h1><ol>` + hits.slice(0, 50).map(([, [to, page, heading, text]]) =>
    `<li><a href="${escaped(to)}">${escaped(heading)}</a> · ${escaped(page)}<small>${excerpt(words, text)}</small></li>`)
    .join("") + "</ol>";
}

box.addEventListener("input", search);
found.addEventListener("click", (event) => {
  if (event.target.closest("a")) { box.value = ""; search(); }
});
