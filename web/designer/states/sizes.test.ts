// The server guesses how large things are drawn where it makes room between them (src/mlab/designer/drawing/sizes.cc). Both are held
// to the same drawings of every kind of node and state: src/mlab/designer/drawing/sizes_test.cc writes them.
import { readFileSync } from "node:fs";
import { fromJson, type JsonValue } from "@bufbuild/protobuf";
import { expect, test } from "vitest";
import { wiredInputsOf } from "../drawing/flow.ts";
import { formOf } from "../drawing/form.ts";
import { DrawingSchema } from "../session/protocol.ts";
import { stateSize } from "./form.ts";

interface Golden {
  /** Of nodes, then states: width, height. */
  readonly sizes: readonly (readonly [number, number])[];
  readonly drawing: JsonValue;
}

const golden = JSON.parse(readFileSync("designer/states/testdata/sizes.golden", "utf8")) as Golden[];

test.each(golden.map(({ sizes, drawing }) => ({ sizes, drawing: fromJson(DrawingSchema, drawing) })))(
  "what is drawn on $drawing.page.path has the size that the server takes it to have",
  ({ sizes, drawing }) => {
    const wired = wiredInputsOf(drawing);
    const forms = [...drawing.nodes.map((node) => formOf(node, wired)), ...drawing.states.map(stateSize)];
    const names = [...drawing.nodes, ...drawing.states].map(({ name }) => name);
    expect(forms.map(({ width, height }, i) => [names[i], width, height])).toEqual(
      sizes.map(([width, height], i) => [names[i], width, height]),
    );
  },
);
