import { describe, expect, it } from "vitest";
import { kDefaultSettings, withLayer } from "../../core/map_settings.ts";
import { readMapSettings } from "./map_settings.ts";

describe("the stored look of the map", () => {
  it("comes back, but for the theme", () => {
    const stored = {
      ...withLayer(kDefaultSettings, "grid", false),
      trails: "stay" as const,
      notation: "mgrs" as const,
      theme: "dark" as const,
    };
    expect(readMapSettings(JSON.parse(JSON.stringify(stored)), kDefaultSettings)).toEqual({
      ...stored,
      theme: "light",
    });
  });
  it("keeps what it is without where that makes no sense", () => {
    for (const junk of [
      null,
      7,
      { trails: "smoke", robotScale: "big", layers: { grid: 3, moon: true } },
      { robotScale: -4, notation: "stars" },
    ]) {
      expect(readMapSettings(junk, kDefaultSettings)).toEqual(kDefaultSettings);
    }
  });
});
