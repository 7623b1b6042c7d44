// Highlights of a game: goals, kicks of a shoot-out, stops, cards.

// A goal and its call can be a packet or two apart.
const kSameGoal_s = 1;
// A person shows a card some seconds after AutoRef.
const kSameCard_s = 10;
const kMostHighlights = 4000;

// Events name sides by colour.
function sideNamed(name) {
  const side = kSideNames.indexOf(name);
  return side < 0 ? null : side;
}

function goalsOf(signals) {
  const goals = [];
  let last = signals[0];
  for (const signal of signals) {
    for (const side of [0, 1]) {
      if (signal.goals[side] <= last.goals[side] || signal.stage === "SHOOTOUT") continue;
      const title = `Goal for ${kSideNames[side]}, ${signal.goals[0]} : ${signal.goals[1]}`;
      goals.push({time_s: signal.time_s, kind: "goal", side, title, reason: ""});
    }
    last = signal;
  }
  return goals;
}

// Without the referee's reasons, derive stops from commands and counters.
function stopsOf(signals) {
  const stops = [];
  signals.forEach((signal, i) => {
    const before = signals[i - 1];
    if (!before || signal.command === before.command) return;
    if (signal.command !== "STOP" && signal.command !== "HALT") return;
    if (kindOfCommand(before.command) === "GOAL") return;
    if (signal.stage === "SHOOTOUT" && before.command === "NORMAL_START") return;  // a kick is over
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

// The title of a card, with the reason for it if known.
function cardTitle({card, card_reason}, side) {
  const whose = side === null ? "each side" : kSideNames[side];
  return `${capitalised(card)} card for ${whose}` + (card_reason ? `: ${card_reason}` : "");
}

function highlightOfDecision(decision) {
  const side = sideNamed(decision.offender);
  const restart = decision.restart ? `Then ${commandTitle(decision.restart).toLowerCase()}.` : "";
  const isCard = decision.card === "yellow" || decision.card === "red";
  const blame = side === null ? "" : `, by ${kSideNames[side]}`;
  const title = isCard ? cardTitle(decision, side) : eventTitle(decision.event) + blame;
  const evidence = decision.reason ?? "";
  return {
    time_s: decision.time_s,
    kind: isCard ? "card" : "stop",
    color: decision.card,
    side,
    title,
    reason: [evidence === `${title}.` ? "" : evidence, restart].filter(Boolean).join(" "),
    rule: decision.rule ?? "",
    position_m: decision.position_m,
  };
}

// Adds the referee's reasons to highlights found in the signals. Returns the decisions that were used,
// each with its highlight.
function addReasons(moments, decisions, events) {
  const calls = decisions.filter((decision) => events.includes(decision.event));
  const used = new Map();
  for (const moment of moments) {
    const call = calls.find((one) => Math.abs(one.time_s - moment.time_s) <= kSameGoal_s && !used.has(one));
    if (!call) continue;
    used.set(call, moment);
    moment.reason = call.reason ?? "";
    moment.rule = call.rule ?? "";
    moment.position_m = call.position_m;
  }
  return used;
}

function highlightOfKick(kick) {
  return {time_s: kick.time_s, kind: kick.scored ? "goal" : "miss", side: kick.side,
          title: kickTitle(kick), reason: ""};
}

function titleOfRecorded({recorded}) {
  return isCommand(recorded) ? commandTitle(recorded) : recorded;
}

function highlightOfRecorded(call) {
  const reason = call.autoref ? "AutoRef made the same call." : `${call.other}.`;
  const title = `Recorded: ${titleOfRecorded(call)}`;
  const isMissed = !call.autoref;
  return {time_s: call.time_s, kind: "recorded", side: null, isMissed, isDisagreement: isMissed, title, reason};
}

// The highlight of AutoRef's decision in this comparison. Several decisions can have the same time, for
// example a foul and a card.
function highlightOfAutoref({autoref, autoref_s}, highlights) {
  const made = [...highlights.keys()].filter((one) => Math.abs(one.time_s - autoref_s) < 1e-3);
  const named = made.find(({event}) => event === autoref.split(" (")[0]);
  return highlights.get(named ?? made[0]);
}

function withSentence(reason, sentence) {
  return `${reason} ${sentence}`.trim();
}

// Turns the highlight of AutoRef's call into one of a call by both referees.
function addAgreement(moment, call) {
  moment.reason = withSentence(moment.reason, `Recorded: ${titleOfRecorded(call)}.`);
  if (moment.kind !== "stop") return;
  moment.kind = "recorded";
  moment.title = `Both: ${moment.call}`;
}

function addDisagreement(moment, {other}) {
  moment.isDisagreement = true;
  moment.reason = withSentence(moment.reason, `${capitalised(other)}.`);
}

// Adds the recorded referee's calls to AutoRef's highlights. Returns highlights of the other recorded calls.
function addRecorded(highlights, compared) {
  const others = [];
  for (const call of compared) {
    const moment = call.autoref ? highlightOfAutoref(call, highlights) : undefined;
    if (call.recorded && !moment) others.push(highlightOfRecorded(call));
    else if (call.recorded) addAgreement(moment, call);
    else if (moment) addDisagreement(moment, call);
  }
  return others;
}

// The recorded cards that AutoRef did not show. AutoRef's highlights of the other cards say that both did.
function otherCards(recorded, calls) {
  const left = calls.filter(({kind}) => kind === "card");
  return recorded.filter((card) => {
    const isSame = (one) => one.color === card.color && one.side === card.side;
    const place = left.findIndex((one) => isSame(one) && Math.abs(one.time_s - card.time_s) <= kSameCard_s);
    if (place < 0) return true;
    const [own] = left.splice(place, 1);
    own.title = `Both: ${own.call}`;
    return false;
  });
}

// AutoRef's calls and the recorded referee's; a call by both is listed once. `shown` contains the decisions
// that belong to other highlights.
function comparedCallsOf({signals, decisions, compared}, shown) {
  const calls = new Map();
  for (const decision of decisions.filter((one) => !shown.has(one))) {
    const call = highlightOfDecision(decision);
    calls.set(decision, {...call, call: call.title, title: `AutoRef: ${call.title}`});
  }
  const recorded = addRecorded(new Map([...shown, ...calls]), compared);
  const own = [...calls.values()];
  return [...own, ...otherCards(cardsOf(signals), own), ...recorded];
}

// Calls from the decisions or, if there are none, from the signals.
function callsOf({signals, decisions}, shown) {
  if (decisions.length === 0) return [...stopsOf(signals), ...cardsOf(signals)];
  return decisions.filter((one) => one.event !== "goal" && !shown.has(one)).map(highlightOfDecision);
}

// The newest highlights in order of time. The score is always the recorded one, even if the decisions
// disagree.
function highlightsOf(game, kicks) {
  const {signals, decisions} = game;
  if (signals.length === 0 && !game.compared) return [];
  const goals = goalsOf(signals);
  const counted = addReasons(goals, decisions, ["goal"]);
  const shots = kicks.map(highlightOfKick);
  const shown = addReasons(shots, decisions, ["goal", "penalty_kick_failed"]);
  const others = game.compared ? comparedCallsOf(game, new Map([...shown, ...counted])) : callsOf(game, shown);
  return [...goals, ...shots, ...others].sort((a, b) => a.time_s - b.time_s).slice(-kMostHighlights);
}
