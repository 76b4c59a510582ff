// Looks for the words of the box in searchIndex, [address, page, heading, text]
// of each section, table row and class; all words have to begin a word there.
const box = document.getElementById("search");
const found = document.getElementById("found");
const escaped = (text) => text.replace(/[&<>"]/g, (c) => `&#${c.charCodeAt(0)};`);

function score(words, [, page, heading, text]) {
  let sum = 0;
  for (const word of words) {
    const times = (where) => (where.match(word) || []).length;
    const points = 20 * times(heading) + 5 * times(page) + Math.min(times(text), 8);
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

function search() {
  const query = box.value.trim();
  const words = query.split(/[\s/]+/).filter(Boolean).map((word) =>
    new RegExp("(?<![\\p{L}\\p{N}])" + word.replace(/[.*+?^${}()|[\]\\]/g, "\\$&"), "giu"));
  found.hidden = query.length < 2;
  document.getElementById("text").hidden = !found.hidden;
  if (found.hidden) return;
  const hits = searchIndex.map((entry) => [score(words, entry), entry])
    .filter(([points]) => points > 0).sort((a, b) => b[0] - a[0]);
  found.innerHTML = `<h1>${hits.length} places</h1><ol>` + hits.slice(0, 50).map(([, [to, page, heading, text]]) =>
    `<li><a href="${escaped(to)}">${escaped(heading)}</a> · ${escaped(page)}<small>${excerpt(words, text)}</small></li>`)
    .join("") + "</ol>";
}

box.addEventListener("input", search);
found.addEventListener("click", (event) => {
  if (event.target.closest("a")) { box.value = ""; search(); }
});
