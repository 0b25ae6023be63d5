import { create } from "@bufbuild/protobuf";
import { describe, expect, it } from "vitest";
import { PlanSchema } from "../../core/names.ts";
import { isWide, placesIn, renamedText, summary } from "./renaming.ts";

const here = { path: "a.mdl", uses: [{ begin: 1 }, { begin: 9 }] };
const kept = { path: "b.cdl", kept: "is read only" };

describe("a plan of a renaming", () => {
  it("counts places, and files that change", () => {
    const plan = create(PlanSchema, { files: [here, { path: "c.odl", uses: [{ begin: 3 }] }, kept] });
    expect(placesIn(plan)).toBe(3);
    expect(summary(plan)).toBe("3 places in 2 files");
  });
  it("is wide where more than one file is concerned, or one stays as it is", () => {
    expect(isWide(create(PlanSchema, { files: [here] }))).toBe(false);
    expect(isWide(create(PlanSchema, { files: [here, here] }))).toBe(true);
    expect(isWide(create(PlanSchema, { files: [kept] }))).toBe(true);
  });
  it("is told with what follows from it", () => {
    const plan = create(PlanSchema, { from: "Far", to: "Gate", files: [here], notes: ["b.cdl is read only"] });
    expect(renamedText(plan)).toBe("Renamed Far to Gate: 2 places in 1 file. b.cdl is read only");
  });
});
