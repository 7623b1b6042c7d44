// The controls that select possession chains: by team, by how they began and ended, and by shots.

function addOptions(id, options) {
  const box = document.getElementById(id);
  for (const [value, title] of options) box.append(new Option(title, value));
}

// Fills the lists of choices and calls `onChange()` when the user has changed the filter. `kinds` is
// game.chainKinds.
function listenToFilter(filter, kinds, onChange) {
  addOptions("chainSide", kSideNames.map((name, side) => [String(side), capitalised(name)]));
  addOptions("chainStart", kinds.starts.map((name) => [name, chainKindTitle(name)]));
  addOptions("chainEnd", kinds.ends.map((name) => [name, chainKindTitle(name)]));
  for (const [id, key] of [["chainSide", "side"], ["chainStart", "start"], ["chainEnd", "end"]]) {
    const box = document.getElementById(id);
    box.value = "";  // browsers restore earlier choices
    box.addEventListener("change", () => {
      filter[key] = box.value;
      onChange();
    });
  }
}
