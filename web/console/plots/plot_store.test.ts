import { describe, expect, it } from "vitest";
import { initialPlots, plotsToKeep } from "./plot_store.ts";

describe("kept plots", () => {
  it("come back as they were, live", () => {
    const state = {
      ...initialPlots(null),
      specs: [{ quantity: "speed" as const, robot: 2, unit: "", port: "" }],
      together: true,
      window: 10,
      view: { live: false as const, from: 1, to: 2 },
    };
    expect(initialPlots(plotsToKeep(state))).toEqual({ ...state, view: { live: true, window: 10 } });
  });
  it("that are damaged are as none", () => {
    for (const text of ["", "{", "3", "null", '{"specs":7,"window":"x"}']) {
      expect(initialPlots(text)).toMatchObject({ specs: [], window: 60 });
    }
  });
});
