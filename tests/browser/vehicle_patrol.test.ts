// A patrol of vehicles, driven from the console: a ROS 2 robot, a rover under MAVLink, and one that is simulated.
import { spawnSync } from "node:child_process";
import { cpSync } from "node:fs";
import { join } from "node:path";
import { expect, onTestFinished, test } from "vitest";
import { Agent } from "./agent.ts";
import { look, Project } from "./begin.ts";
import { Mlab } from "./mlab.ts";
import { canPlayVehicles, movingVehicles, root, startMavlinkRover, startRos2Robot } from "./played_vehicles.ts";

test.skipIf(!canPlayVehicles)(
  "two vehicles and a simulated robot patrol in one formation, as the console says; it is recorded and replayed",
  async () => {
    const fleet = `vehicles-${process.pid}`;
    const project = new Project("");
    onTestFinished(() => project.remove());
    const folder = join(root, "tests", "fleets", "vehicles");
    for (const name of ["patrol.mdl", "patrol.odl"]) cpSync(join(folder, name), project.path(name));
    await Agent.start(fleet, "here");
    const [scout, rover] = await Promise.all([
      startRos2Robot(fleet, "veh-1", "8,19,0", join(folder, "yard.odl")),
      startMavlinkRover(fleet, "veh-2"),
    ]);
    const recording = project.path("patrol.mcap");
    const options = ["--robots", "fleet", "--fleet", fleet, ...movingVehicles, "--record", recording];
    const mlab = await Mlab.start(project.path("patrol.mdl"), "--project", project.folder, ...options);
    onTestFinished(async () => {
      await mlab.stop();
    });
    const console = await look(mlab);
    await console.reaches("Ready");
    await console.main.click();
    await console.reaches("Running");
    for (const { robot } of [scout, rover]) await robot.says("a run drives it");
    await console.panel("Robots");
    await expect.poll(async () => (await console.place("Robot 1")).x).toBeGreaterThan(9);
    await expect.poll(async () => (await console.place("Robot 2")).x).toBeGreaterThan(9);

    // The emergency stop reaches the vehicles, which say so themselves.
    const before = scout.played.output.length;
    await console.stop.click();
    await console.page.getByText("EMERGENCY STOP: all robots stand and take no orders.").waitFor();
    for (const { robot } of [scout, rover]) await robot.says("it stands: the emergency stop holds");
    await expect.poll(() => scout.played.output.slice(before)).toContain("stands at");
    await console.button("Release the stop").first().click();
    for (const { robot } of [scout, rover]) await robot.says("the emergency stop was released by");
    await console.reaches("Paused");
    await console.main.click();

    await console.reaches("Done");
    await console.page.goto("about:blank"); // a page whose server ends complains
    await mlab.end();
    const command = process.env.MLAB_COMMAND ?? "mlab";
    const again = spawnSync(command, ["replay", recording, "--headless"], { encoding: "utf8" });
    expect(again.stdout + again.stderr).toContain("as recorded");
    expect(again.status).toBe(0);
  },
);
