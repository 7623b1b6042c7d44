// Moments of a game that people want to find: goals, stops, cards.

// A goal and the call of it may be told apart by a packet or two.
const kSameGoal_s = 1;
const kMostHighlights = 4000;

function sideNamed(name) {
  return name === "west" ? 0 : name === "east" ? 1 : null;
}

function goalsOf(signals) {
  const goals = [];
  let last = signals[0];
  for (const signal of signals) {
    for (const side of [0, 1]) {
      if (signal.goals[side] <= last.goals[side]) continue;
      const title = `Goal for ${kSideNames[side]}, ${signal.goals[0]} : ${signal.goals[1]}`;
      goals.push({time_s: signal.time_s, kind: "goal", side, title, reason: ""});
    }
    last = signal;
  }
  return goals;
}

// Where nobody tells the referee's reasons, commands and counts must do.
function stopsOf(signals) {
  const stops = [];
  signals.forEach((signal, i) => {
    const before = signals[i - 1];
    if (!before || signal.command === before.command) return;
    if (signal.command !== "STOP" && signal.command !== "HALT") return;
    if (kindOfCommand(before.command) === "GOAL") return;
    const reason = signal.next ? `Next: ${commandTitle(signal.next)}` : "";
    stops.push({time_s: signal.time_s, kind: "stop", side: null, title: commandTitle(signal.command), reason});
  });
  return stops;
}

function cardsOf(signals) {
  const cards = [];
  signals.forEach((signal, i) => {
    if (i === 0) return;
    for (const [color, counts] of [["yellow", "yellowCards"], ["red", "redCards"]]) {
      for (const side of [0, 1]) {
        if (signal[counts][side] <= signals[i - 1][counts][side]) continue;
        const title = `${capitalised(color)} card for ${kSideNames[side]}`;
        cards.push({time_s: signal.time_s, kind: "card", color, side, title, reason: ""});
      }
    }
  });
  return cards;
}

// The referee's sentences tell robots by their side.
function byColor(text) {
  return text.replace(/\b(west|east) (?=\d)/g, (_, side) => `${kSideNames[sideNamed(side)]} `);
}

function highlightOfDecision(decision) {
  const side = sideNamed(decision.offender);
  const restart = decision.restart ? `Then ${commandTitle(decision.restart).toLowerCase()}.` : "";
  const isCard = decision.card === "yellow" || decision.card === "red";
  const blame = side === null ? "" : `, by ${kSideNames[side]}`;
  return {
    time_s: decision.time_s,
    kind: isCard ? "card" : "stop",
    color: decision.card,
    side,
    title: eventTitle(decision.event) + blame,
    reason: [byColor(decision.reason ?? ""), restart].filter(Boolean).join(" "),
    rule: decision.rule ?? "",
    position_m: decision.position_m,
  };
}

function addReasons(goals, decisions) {
  const calls = decisions.filter((decision) => decision.event === "goal");
  for (const goal of goals) {
    const call = calls.find((one) => Math.abs(one.time_s - goal.time_s) <= kSameGoal_s);
    if (!call) continue;
    goal.reason = byColor(call.reason ?? "");
    goal.rule = call.rule ?? "";
    goal.position_m = call.position_m;
  }
}

// All of them, by time. The score is the recorded one whatever the decisions say.
function highlightsOf({signals, decisions}) {
  if (signals.length === 0) return [];
  const goals = goalsOf(signals);
  addReasons(goals, decisions);
  const others = decisions.length > 0
    ? decisions.filter((decision) => decision.event !== "goal").map(highlightOfDecision)
    : [...stopsOf(signals), ...cardsOf(signals)];
  return [...goals, ...others].sort((a, b) => a.time_s - b.time_s).slice(0, kMostHighlights);
}
