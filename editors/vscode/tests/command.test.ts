import { expect, it } from "vitest";
import { commandOf } from "../src/command";

it("finds the command that the setting means", () => {
  expect(commandOf("mlab", "/project", "/users/me")).toBe("mlab");
  expect(commandOf("  ", "/project", "/users/me")).toBe("mlab");
  expect(commandOf("./mlab", "/project", "/users/me")).toBe("/project/mlab");
  expect(commandOf("./mlab", undefined, "/users/me")).toBe("./mlab");
  expect(commandOf("/usr/bin/mlab", "/project", "/users/me")).toBe("/usr/bin/mlab");
  expect(commandOf("~/bin/mlab", "/project", "/users/me")).toBe("/users/me/bin/mlab");
});
