#include "scenefile/gradebook/report_page.h"

#include "scenefile/gradebook/markup.h"

#include <fmt/format.h>

namespace scenefile {

namespace {

constexpr std::string_view style = R"(
:root { color-scheme: light dark; --ink: #1c1e21; --paper: #fff; --soft: #f1f3f5; --line: #c9ced6; --dim: #565d68;
  --good: #1d6b3a; --bad: #b3261e; --none: #7a5600; --link: #0b57a4; --stage: #14161a; }
@media screen and (prefers-color-scheme: dark) { :root { --ink: #e6e8eb; --paper: #15171a; --soft: #22262b;
  --line: #3f464f; --dim: #a8b0bb; --good: #6fd191; --bad: #ff8f85; --none: #f0c264; --link: #8ec5ff; } }
* { box-sizing: border-box; }
body { font: 16px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper); margin: 0; }
main { max-width: 100rem; margin: 0 auto; padding: 1.5rem 1.5rem 4rem; }
a { color: var(--link); }
:focus-visible { outline: 3px solid var(--link); outline-offset: 2px; }
h1 { font-size: 1.6rem; line-height: 1.25; margin: 0; } h2 { font-size: 1.2rem; margin: 2.5rem 0 .5rem; }
h3 { font-size: 1rem; margin: 1.25rem 0 .25rem; } h4 { font-size: 1rem; margin: 0 0 .25rem; }
p { margin: .25rem 0; } h1, h2, h3, h4, p, li, summary { overflow-wrap: anywhere; }
.dim, figcaption, small { color: var(--dim); }
code { font-size: .8rem; color: var(--dim); background: var(--soft); border-radius: 4px; padding: .05rem .35rem; font-weight: 400; }
.lead { font-size: 1.15rem; margin: 1rem 0 .5rem; }
.passed { color: var(--good); } .differs { color: var(--bad); } .missing, .unreadable { color: var(--none); }
.bar { display: flex; height: .6rem; border-radius: .3rem; overflow: hidden; background: var(--soft); max-width: 44rem; }
.bar i { background: currentColor; }
.key { display: flex; flex-wrap: wrap; gap: .25rem 1.5rem; list-style: none; margin: .5rem 0 0; padding: 0; }
.filters { display: flex; flex-wrap: wrap; align-items: center; gap: .5rem 1rem; margin: 1.5rem 0 .5rem; }
.filters label { display: flex; gap: .4rem; align-items: center; }
input, select, .push { font: inherit; color: inherit; background: var(--soft); border: 1px solid var(--line);
  border-radius: 6px; padding: .25rem .5rem; min-height: 2rem; }
input, select { max-width: 16rem; } .push { cursor: pointer; }
.wide { overflow: auto; width: fit-content; max-width: 100%; max-height: 85vh; border: 1px solid var(--line); border-radius: 6px; }
table { border-collapse: separate; border-spacing: 0; font-size: .9rem; font-variant-numeric: tabular-nums; }
th, td { padding: .3rem .6rem; border-bottom: 1px solid var(--line); text-align: left; background: var(--paper); }
tbody tr:last-child > * { border-bottom: 0; } tbody tr:hover > * { background: var(--soft); }
thead th { position: sticky; top: 0; background: var(--soft); z-index: 2; vertical-align: bottom; }
thead th:first-child { left: 0; z-index: 3; }
tbody th { position: sticky; left: 0; z-index: 1; font-weight: 600; max-width: 16rem; overflow-wrap: anywhere; }
th button { font: inherit; font-weight: 600; color: inherit; background: none; border: 0; padding: 0; cursor: pointer; text-align: left; }
th[aria-sort=ascending] button::after { content: " ▲"; } th[aria-sort=descending] button::after { content: " ▼"; }
th.picture { padding: .5rem .3rem; }
th.picture button { writing-mode: vertical-rl; transform: rotate(180deg); max-height: 11rem; white-space: nowrap;
  overflow: hidden; text-overflow: ellipsis; display: block; margin: 0 auto; }
td:nth-child(n+4) { text-align: center; padding: .3rem; min-width: 2.2rem; font-weight: 700; }
td:nth-child(n+4) a { color: inherit; text-decoration: none; display: block; } td:nth-child(n+4) a:hover { text-decoration: underline; }
td.mistakes { min-width: 16rem; max-width: 26rem; line-height: 1.35; } td.mistakes span { display: block; }
details { border-top: 1px solid var(--line); } details:last-of-type { border-bottom: 1px solid var(--line); }
summary { cursor: pointer; padding: .5rem 0; } summary b { margin-right: .5rem; }
ul { margin: .25rem 0; padding-left: 1.25rem; } .body { padding-bottom: 1.5rem; }
.mistakes-list { list-style: none; padding: 0; display: grid; gap: .5rem; max-width: 60rem; }
.mistakes-list li { border-left: 4px solid var(--bad); background: var(--soft); border-radius: 0 6px 6px 0; padding: .5rem .75rem; }
.mistakes-list li.part { border-color: var(--none); }
.mistakes-list p:first-child b { font-size: 1.05rem; }
.common p { max-width: 60rem; }
.cards { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 34rem), 1fr)); gap: 1rem; }
.card { border: 1px solid var(--line); border-radius: 8px; padding: .75rem; min-width: 0; scroll-margin-top: 1rem; }
.card:target { outline: 3px solid var(--link); }
.card small { display: block; overflow-wrap: anywhere; }
.shot { font: inherit; color: inherit; background: none; border: 0; padding: 0; cursor: zoom-in; text-align: center; }
.card .shot { display: block; width: 100%; margin: .5rem 0 .25rem; }
.card img { display: block; width: 100%; height: auto; border-radius: 6px; background: var(--stage); }
.card .shot::before { content: "reference picture difference"; display: block; text-align-last: justify; font-size: .85rem; color: var(--dim); }
.thumbs { display: flex; flex-wrap: wrap; gap: .75rem; }
.thumbs .shot { width: 6rem; font-size: .8rem; line-height: 1.2; overflow-wrap: anywhere; align-self: start; }
.thumbs img { display: block; object-fit: cover; border-radius: 6px; background: var(--stage); margin-bottom: .25rem; }
dialog { width: min(96vw, 100rem); max-height: 96vh; color: var(--ink); background: var(--paper); border: 1px solid var(--line);
  border-radius: 10px; padding: 1rem; }
dialog::backdrop { background: rgb(0 0 0 / .7); }
dialog h2 { margin: 0; }
.panes { display: grid; grid-template-columns: repeat(3, 1fr); gap: .5rem; margin: .5rem 0; }
.panes figure { margin: 0; } .panes img { display: block; width: 100%; object-fit: cover; background: var(--stage); border-radius: 6px; }
.flicker .panes { grid-template-columns: 1fr; justify-items: center; } .flicker figure:not(:first-child) { display: none; }
.flicker .panes img { width: auto; height: 64vh; max-width: 100%; }
.keys { display: flex; flex-wrap: wrap; gap: .5rem; align-items: center; }
.keys .push:last-child { margin-left: auto; }
.push[aria-pressed=true] { background: var(--link); color: var(--paper); }
kbd { font: inherit; font-size: .8rem; border: 1px solid currentColor; border-radius: 4px; padding: 0 .3rem; opacity: .85; }
@media (max-width: 40rem) { main { padding: .75rem .75rem 3rem; } th, td { padding: .3rem .4rem; }
  tbody th { min-width: 7rem; max-width: 8rem; } tbody th a { display: -webkit-box; -webkit-box-orient: vertical; -webkit-line-clamp: 3; overflow: hidden; }
  th.mistakes, td.mistakes { display: none; }
  td:nth-child(n+4) { padding: .3rem .15rem; min-width: 2rem; } .panes { grid-template-columns: 1fr; } .flicker .panes img { width: 100%; height: auto; }
  .filters label { flex: 1 1 100%; } .filters label > * { flex: 1; max-width: none; } }
@media print { @page { margin: 12mm; } body { font-size: 10pt; } main { max-width: none; padding: 0; }
  .filters, dialog, .push { display: none; } .wide { overflow: visible; max-height: none; width: 100%; border: 0; }
  table { width: 100%; table-layout: fixed; font-size: 8pt; } thead { display: table-header-group; }
  th, td { padding: .1rem; } thead th, tbody th { position: static; } thead th:first-child { width: 20%; } thead th:nth-child(2) { width: 7%; }
  th.mistakes, td.mistakes { display: none; } td:nth-child(n+4) { min-width: 0; padding: .1rem 0; } th.picture { padding: .2rem 0; }
  tr, .card, .mistakes-list li, .thumbs .shot { break-inside: avoid; } summary, h2, h3 { break-after: avoid; }
  .cards { grid-template-columns: 1fr 1fr; gap: 3mm; } .card { padding: 2mm; font-size: 8pt; } .bar, img { print-color-adjust: exact; } a { text-decoration: none; } }
)";

constexpr std::string_view script = R"(
const all = (query, root = document) => [...root.querySelectorAll(query)];
const one = (query, root = document) => root.querySelector(query);
const text = element => element ? element.textContent : '';

// The table: sorts by a column, and filters the rows.
const table = one('table.results');
if (table) {
  const heads = [...table.tHead.rows[0].cells], body = table.tBodies[0], states = ['passed', 'differs', 'missing', 'unreadable'];
  // The links say what the picture they lead to says.
  all('td > a', table).forEach(link => {
    const card = document.getElementById(link.hash.slice(1)).closest('.card');
    link.title = link.parentNode.className + (card ? ': ' + all('.why, p.dim', card).map(text).join('; ') : '');
    link.ariaLabel = link.title;
  });
  const key = (row, column) => {
    const cell = row.cells[column], state = states.findIndex(name => cell.classList.contains(name));
    return state + ' ' + (state > 0 ? cell.firstChild.ariaLabel : text(cell));
  };
  heads.forEach((head, column) => one('button', head).addEventListener('click', () => {
    const down = head.getAttribute('aria-sort') === 'ascending';
    heads.forEach(h => h.removeAttribute('aria-sort'));
    head.setAttribute('aria-sort', down ? 'descending' : 'ascending');
    const rows = [...body.rows].sort((a, b) => key(a, column).localeCompare(key(b, column), undefined, {numeric: true}));
    body.append(...(down ? rows.reverse() : rows));
  }));
  const [name, cause, state, shown] = ['#name', '#cause', '#state', '#shown'].map(id => one(id));
  const plain = name => name.normalize().toLowerCase(); // macOS decomposes letters with accents
  const filter = () => {
    for (const row of body.rows) {
      const passed = !one('.differs, .missing, .unreadable', row);
      row.hidden = !plain(text(row.cells[0])).includes(plain(name.value)) ||
        (cause.value && !row.dataset.causes.split(' ').includes(cause.value)) ||
        (state.value && (state.value === 'passed') !== passed);
    }
    shown.textContent = [...body.rows].filter(row => !row.hidden).length + ' of ' + body.rows.length + ' students';
  };
  [name, cause, state].forEach(field => field.addEventListener('input', filter));
  all('button[data-cause]').forEach(button => button.addEventListener('click', () => {
    [name.value, cause.value, state.value] = ['', button.dataset.cause, ''];
    filter();
    table.scrollIntoView({block: 'nearest'});
    cause.focus();
  }));
  filter();
}

// Links open the details that contain their target; printing opens all.
const show = () => {
  const target = location.hash && document.getElementById(location.hash.slice(1));
  const box = target && target.closest('details');
  if (box) { box.open = true; target.scrollIntoView(); }
};
addEventListener('hashchange', show);
let closed = [];
addEventListener('beforeprint', () => {
  closed = all('details:not([open])');
  closed.forEach(box => { box.open = true; });
});
addEventListener('afterprint', () => closed.forEach(box => { box.open = false; }));
show();

// The dialog with a picture: reference, picture and difference are the thirds of one image.
const box = one('dialog'), shots = all('button.shot'), panes = all('figure', box), flicker = one('#flicker');
let at = 0, timer = 0;
const third = (figure, i) => {
  one('img', figure).style.objectPosition = 50 * i + '% 0';
  one('figcaption', figure).textContent = ['Reference', 'Picture', 'Difference'][i];
};
const swap = () => third(panes[0], one('img', panes[0]).style.objectPosition.startsWith('0') ? 1 : 0);
const setFlicker = on => {
  clearInterval(timer);
  box.classList.toggle('flicker', on);
  flicker.ariaPressed = on;
  third(panes[0], 0);
  // Fewer than three changes a second; by hand for those who do not want motion.
  if (on) { swap(); timer = matchMedia('(prefers-reduced-motion: reduce)').matches ? 0 : setInterval(swap, 500); }
};
const pressFlicker = () => box.classList.contains('flicker') && !timer ? swap() : setFlicker(!box.classList.contains('flicker'));
const view = index => {
  at = (index + shots.length) % shots.length;
  const shot = shots[at], card = shot.closest('.card'), image = one('img', shot);
  one('h2', box).textContent = text(one('.who', shot.closest('.student'))) + ': ' + text(one('bdi', card || shot));
  one('#why').textContent = card ? all('.why', card).map(text).join('; ') : 'passed';
  one('#measures').textContent = card ? text(one('.measures', card)) : shot.title;
  one('#place').textContent = (at + 1) + ' of ' + shots.length;
  const load = () => panes.forEach((figure, i) => {
    const pane = one('img', figure);
    pane.src = image.src;
    pane.alt = ['Reference', 'Picture', 'Difference'][i] + ' of ' + text(one('bdi', card || shot));
    pane.style.aspectRatio = (image.naturalWidth || 12) / 3 + ' / ' + (image.naturalHeight || 3);
    third(figure, i);
  });
  load();
  // An image that was not needed before.
  if (!image.naturalWidth) { image.loading = 'eager'; image.decode().then(load, () => {}); }
  if (!box.open) box.showModal();
};
const step = by => { setFlicker(false); view(at + by); };
shots.forEach((shot, i) => shot.addEventListener('click', () => { setFlicker(false); view(i); }));
one('#back').addEventListener('click', () => step(-1));
one('#on').addEventListener('click', () => step(1));
flicker.addEventListener('click', pressFlicker);
box.addEventListener('keydown', event => {
  if (event.ctrlKey || event.altKey || event.metaKey) return;
  const action = {ArrowLeft: () => step(-1), ArrowRight: () => step(1), f: pressFlicker, F: pressFlicker}[event.key];
  if (action && !event.repeat) { event.preventDefault(); action(); }
});
box.addEventListener('click', event => { if (event.target === box) box.close(); });
box.addEventListener('close', () => {
  setFlicker(false);
  const shot = shots[at], details = shot.closest('details');
  if (details) details.open = true;
  shot.focus();
});
)";

constexpr std::string_view dialog = R"(<dialog aria-labelledby="what">
<h2 id="what"></h2>
<p id="why"></p>
<div class="panes"><figure><figcaption></figcaption><img alt=""></figure><figure><figcaption></figcaption><img alt="">
</figure><figure><figcaption></figcaption><img alt=""></figure></div>
<p id="measures" class="dim"></p>
<form method="dialog" class="keys"><button type="button" id="back" class="push">Previous <kbd>←</kbd></button>
<button type="button" id="on" class="push">Next <kbd>→</kbd></button>
<button type="button" id="flicker" class="push" aria-pressed="false">Flicker reference and picture <kbd>F</kbd></button>
<span id="place" class="dim" role="status"></span>
<button class="push">Close <kbd>Esc</kbd></button></form>
</dialog>
)";

}  // namespace

std::string report_page(std::string_view title, std::string_view date, std::string_view content) {
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
      "name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{0}</title>\n"
      "<style>{1}</style>\n</head>\n<body>\n<main>\n<h1><bdi>{0}</bdi></h1>\n{2}{3}</main>\n"
      "{4}<script>{5}</script>\n</body>\n</html>\n",
      markup(title), style,
      date.empty() ? std::string()
                   : fmt::format("<p class=\"dim\">Graded on {}</p>\n", markup(date)),
      content, dialog, script);
}

}  // namespace scenefile
