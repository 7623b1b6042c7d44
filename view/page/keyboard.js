// Keyboard control. `actions` contains a function for each name in kKeys.

const kKeys = {
  " ": "toggle", k: "toggle",
  ArrowLeft: "back", ArrowRight: "forward",
  ",": "stepBack", ".": "stepForward",
  "+": "faster", "=": "faster", "-": "slower",
  n: "nextEvent", p: "previousEvent",
  g: "nextGoal", G: "previousGoal",
  Home: "toBegin", End: "toEnd",
  1: "layer1", 2: "layer2", 3: "layer3", 4: "layer4", 5: "layer5", 6: "layer6", 7: "layer7", 8: "layer8",
  d: "disagreements",
  c: "nextChain", C: "previousChain",
  m: "nextTurningPoint", M: "previousTurningPoint",
  "?": "help",
};

const kChoiceKeys = ["ArrowLeft", "ArrowRight", "Home", "End"];

function actionFor(event) {
  if (event.ctrlKey || event.metaKey || event.altKey) return null;
  if (event.shiftKey && event.key === "ArrowLeft") return "stepBack";
  if (event.shiftKey && event.key === "ArrowRight") return "stepForward";
  return kKeys[event.key] ?? null;
}

// A focused button handles the space bar itself, and a list of choices also letters and the keys that move in it.
function isForControl({key, target}) {
  const isChoice = target instanceof HTMLSelectElement;
  if (isChoice) return key.length === 1 || kChoiceKeys.includes(key);
  return key === " " && target instanceof HTMLButtonElement;
}

function listenToKeys(actions) {
  document.addEventListener("keydown", (event) => {
    const action = actionFor(event);
    if (!action || isForControl(event)) return;
    event.preventDefault();
    actions[action]();
  });
}
