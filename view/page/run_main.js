// The page of a running experiment. The server computes everything that the page shows.

const kTitle = document.title;
const find = (id) => document.getElementById(id);
const scrollable = () => [...find("results").querySelectorAll(".wide, pre")];

function showProgress({done, total, text, remark}) {
  find("bar").max = Math.max(total, 1);
  find("bar").value = done;
  find("progress").textContent = text;
  find("remark").textContent = remark;
  document.title = total > 0 ? `${done}/${total} \u2013 ${kTitle}` : kTitle;
}

// Keeps the sideways scroll position of tables.
function showResults({html}) {
  const left_px = scrollable().map((box) => box.scrollLeft);
  find("results").innerHTML = html;
  scrollable().forEach((box, i) => { box.scrollLeft = left_px[i] ?? 0; });
}

function span(kind, text) {
  const element = document.createElement("span");
  element.className = kind;
  element.textContent = text;
  return element;
}

function gameItem({id, text, has_page}) {
  const game = document.createElement(has_page ? "a" : "span");
  game.className = "game";
  if (has_page) {
    game.href = `/game?${encodeURIComponent(id)}`;
    game.target = "_blank";
  }
  game.append(span("title", text), span("reason", id));
  const item = document.createElement("li");
  item.append(game);
  return item;
}

function showGames({running, ended}) {
  find("running").replaceChildren(...running.map(gameItem));
  find("ended").replaceChildren(...ended.map(gameItem));
  find("now").hidden = running.length === 0;
  find("before").hidden = ended.length === 0;
}

// The same address may now show another experiment.
let shownTitle = null;
function start({title}) {
  if (shownTitle !== null && title !== shownTitle) location.reload();
  shownTitle = title;
}

const takers = {start, progress: showProgress, results: showResults, games: showGames};
new Connection((message) => { takers[message.type]?.(message); }, (text) => { find("connection").textContent = text; })
  .open();
