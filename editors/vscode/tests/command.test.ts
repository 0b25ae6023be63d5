import { expect, it } from "vitest";
import { commandOf } from "../src/command";

it("finds the command that the setting means", () => {
  expect(commandOf("mlab", "/work", "/home/me")).toBe("mlab");
  expect(commandOf("  ", "/work", "/home/me")).toBe("mlab");
  expect(commandOf("./mlab", "/work", "/home/me")).toBe("/work/mlab");
  expect(commandOf("./mlab", undefined, "/home/me")).toBe("./mlab");
  expect(commandOf("/usr/bin/mlab", "/work", "/home/me")).toBe("/usr/bin/mlab");
  expect(commandOf("~/bin/mlab", "/work", "/home/me")).toBe("/home/me/bin/mlab");
});
