// Runs state charts with an independent interpreter, SCION.
//
//   node run_scxml.mjs FOLDER CASES.json
//
// FOLDER has node_modules in it. CASES.json: a list of { scxml, cycles: [{ path: value }] }. Prints for each case the
// list of what it was in after each cycle: { states: the ids of states that are the robot's own, doing: the states of
// which the data model says what is done there }, sorted.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const [folder, file] = process.argv.slice(2);
const scxml = createRequire(`${folder}/`)("@scion-scxml/scxml");

function prepared(text) {
  return new Promise((resolve, reject) => {
    scxml.documentStringToModel("chart.scxml", text, (error, model) => {
      if (error) return reject(error);
      model.prepare((failed, chart) => (failed ? reject(failed) : resolve(new scxml.core.Statechart(chart))));
    });
  });
}

const results = [];
for (const { scxml: text, cycles } of JSON.parse(readFileSync(file, "utf8"))) {
  const chart = await prepared(text);
  chart.start();
  results.push(
    cycles.map((data) => {
      chart.gen({ name: "cycle", data });
      // With a `-` in them: what the chart needs around the states.
      const states = chart.getFullConfiguration().filter((id) => !id.includes("-") && !id.startsWith("$")).sort();
      const doing = Object.values(chart._model.$serializeDatamodel().doing).filter((one) => one !== null);
      for (const { state, node, value } of doing)
        if (node === undefined && value === undefined) throw new Error(`${state} does not say what it does`);
      return { states, doing: doing.map((one) => one.state).filter((id) => !id.includes("-")).sort() };
    }),
  );
}
console.log(JSON.stringify(results));
