// Keyboard control. `actions` contains a function for each name in kKeys.

const kKeys = {
  " ": "toggle", k: "toggle",
  ArrowLeft: "back", ArrowRight: "forward",
  ",": "stepBack", ".": "stepForward",
  "+": "faster", "=": "faster", "-": "slower",
  n: "nextEvent", p: "previousEvent",
  g: "nextGoal", G: "previousGoal",
  Home: "toBegin", End: "toEnd",
  1: "layer1", 2: "layer2", 3: "layer3", 4: "layer4", 5: "layer5",
  d: "disagreements",
  "?": "help",
};

function actionFor(event) {
  if (event.ctrlKey || event.metaKey || event.altKey) return null;
  if (event.shiftKey && event.key === "ArrowLeft") return "stepBack";
  if (event.shiftKey && event.key === "ArrowRight") return "stepForward";
  return kKeys[event.key] ?? null;
}

// A focused button handles the space bar itself.
function isForButton(event) {
  return event.key === " " && event.target instanceof HTMLButtonElement;
}

function listenToKeys(actions) {
  document.addEventListener("keydown", (event) => {
    const action = actionFor(event);
    if (!action || isForButton(event)) return;
    event.preventDefault();
    actions[action]();
  });
}
