// A small interpreter of the behavior trees that `mlab build --emit btcpp` writes: which states are active, cycle by cycle,
// for given truth values of the conditions. It takes what BehaviorTree.CPP 4 takes (btcpp_rules.mjs), and the nodes do what
// the documentation of that says of them; actions answer RUNNING.
//
//   node run_btcpp.mjs CASES      CASES: [{"tree": XML, "cycles": [[true conditions]]}]; prints [["S1/S0"]], and for a
//                                 tree that is refused {"refused": WHY}
import { readFileSync } from "node:fs";
import { load, pointer } from "./btcpp_rules.mjs";

class Run {
  constructor(tree) {
    this.tree = tree;
    this.blackboard = {};
  }
  evaluate(code) {
    const js = code.replace(/:=/g, "=").replace(/'[^']*'|[A-Za-z_]\w*/g, (word) => (word[0] === "'" ? word : `board.${word}`));
    return new Function("board", `return (${js.replace(/;/g, ",")});`)(this.blackboard);
  }
  // What a node gets on a port.
  input(node, port) {
    const key = pointer(port, node.attributes[port]);
    if (key === undefined) return node.attributes[port];
    if (!(key in this.blackboard)) throw new Error(`port ${port} of ${node.tag}: there is no ${key} on the blackboard`);
    return this.blackboard[key];
  }
  halt(node) {
    node.at = 0;
    for (const child of node.children) this.halt(child);
  }
  finish(node, result) {
    for (const child of node.children) this.halt(child);
    node.at = 0;
    return result;
  }
  tick(node, path) {
    // A state is a reactive sequence with a name.
    const isState = node.tag === "ReactiveSequence" && node.attributes.name;
    const inner = isState ? [...path, node.attributes.name] : path;
    return this.tickKind(node, inner);
  }
  tickKind(node, path) {
    const goesOn = node.tag.endsWith("Sequence") ? "SUCCESS" : "FAILURE";
    switch (node.tag) {
      case "Sequence":
      case "Fallback":
        for (; node.at < node.children.length; ++node.at) {
          const result = this.tick(node.children[node.at], path);
          if (result === "RUNNING") return result;
          if (result !== goesOn) return this.finish(node, result);
        }
        return this.finish(node, goesOn);
      case "ReactiveSequence":
      case "ReactiveFallback":
        for (const [i, child] of node.children.entries()) {
          const result = this.tick(child, path);
          if (result === "RUNNING") {
            for (const [k, other] of node.children.entries()) if (k !== i) this.halt(other);
            return result;
          }
          if (result !== goesOn) return this.finish(node, result);
        }
        return this.finish(node, goesOn);
      case "Inverter":
        return this.tick(node.children[0], path) === "SUCCESS" ? "FAILURE" : "SUCCESS";
      case "Script":
        this.evaluate(node.attributes.code);
        return "SUCCESS";
      case "ScriptCondition":
        return this.evaluate(node.attributes.code) ? "SUCCESS" : "FAILURE";
      case "AlwaysSuccess":
        return "SUCCESS";
      case "AlwaysFailure":
        return "FAILURE";
    }
    for (const port of Object.keys(node.attributes)) this.input(node, port);
    if (node.kind === "Condition") return this.truths.includes(this.input(node, "message")) ? "SUCCESS" : "FAILURE";
    if (node.kind === "Action") {
      this.active.push(path);
      return "RUNNING";
    }
    throw new Error(`there is no node ${node.tag}`);
  }
  cycle(truths) {
    this.truths = truths;
    this.active = [];
    this.tick(this.tree, []);
    if (this.active.length !== 1) throw new Error(`${this.active.length} actions are active`);
    return this.active[0];
  }
}

function outcome({ tree, cycles }) {
  let root;
  try {
    root = load(tree);
  } catch (error) {
    return { refused: error.message };
  }
  const run = new Run(root);
  return cycles.map((truths) => run.cycle(truths).join("/"));
}

console.log(JSON.stringify(JSON.parse(readFileSync(process.argv[2], "utf8")).map(outcome)));
