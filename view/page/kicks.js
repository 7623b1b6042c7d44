// The kicks of a shoot-out, derived from the referee's signals.

// A kick in progress: who takes it, and when it began.
function begunKick(signals, index) {
  const {stage, command, time_s} = signals[index];
  if (stage !== "SHOOTOUT" || command !== "NORMAL_START" || index === 0) return null;
  const side = sideOfCommand(signals[index - 1].command);
  return side === null ? null : {side, began_s: time_s, before: signals[index - 1]};
}

// Whether the kick scored; null while it is in progress. SSL logs do not count these goals but
// contain the command that signals one.
function outcomeOf(kick, signal) {
  const counts = (which) => signal[which][kick.side] > kick.before[which][kick.side];
  if (kindOfCommand(signal.command) === "GOAL") return sideOfCommand(signal.command) === kick.side;
  if (counts("goals") || counts("shootoutGoals")) return true;
  return signal.command === "NORMAL_START" ? null : false;
}

// The kicks in order, each with its side, number, outcome, time and the score after it. A kick that
// the same side retakes does not count.
function kicksOf(signals) {
  const kicks = [];
  let kick = null;
  signals.forEach((signal, i) => {
    if (kick) {
      const scored = outcomeOf(kick, signal);
      if (scored === null) return;
      kicks.push({side: kick.side, scored, time_s: signal.time_s});
      kick = null;
    }
    const begun = begunKick(signals, i);
    if (!begun) return;
    const last = kicks[kicks.length - 1];
    if (last && last.side === begun.side) kicks.pop();
    kick = begun;
  });
  const numbers = [0, 0];
  const standing = [0, 0];
  for (const one of kicks) {
    one.number = ++numbers[one.side];
    if (one.scored) ++standing[one.side];
    one.standing = [...standing];
  }
  return kicks;
}
