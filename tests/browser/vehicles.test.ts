// Robots whose bodies are vehicles: what is told of them, and what is looked at before they move.
import { expect, test } from "vitest";
import { Agent } from "./agent.ts";
import { begin } from "./begin.ts";

const kMission = `MISSION NAME "driven"
OVERLAY demo_c.odl
NEW-ROBOT rover "robot" green "veh-1" (base_velocity = 0.8, max_velocity = 1, robot_radius = 0.3)
UNIT <a> rover
COMMAND LIST:
  0. UNIT a START 20 30
  1. UNIT a MOVETO 90 30
`;

test("a vehicle is marked as real, is told of before it starts, and after", async () => {
  const fleet = `vehicles-${process.pid}`;
  await Agent.vehicle(fleet, "veh-1", "20,30,0");
  const { console } = await begin({
    mission: "demo_c",
    prepare: (folder) => {
      folder.write("demo_c.mdl", kMission);
      folder.write("demo_c.odl", "MISSION-AREA 200 100\nCONTROL MEASURES:\n");
    },
    options: ["--robots", "fleet", "--fleet", fleet, "--real-time"],
  });
  await console.reaches("Ready");
  const robots = await console.panel("Robots");
  await robots.getByRole("img", { name: /^A vehicle: / }).waitFor();
  await console.select("Robot 1");
  const vehicle = (await console.panel("Selection")).getByTestId("vehicle");
  await vehicle.getByText("Vehicle veh-1").waitFor();
  await vehicle.getByText("nobody", { exact: true }).waitFor();
  await vehicle.getByText(/^heard 0\.\d s ago$/).waitFor();

  const preflight = await console.panel("Pre-flight");
  await preflight.getByText(/nothing real moves, so nobody has to sign/).waitFor();
  expect(await preflight.getByTestId(/^item-veh-1\//).count()).toBeGreaterThan(3);

  await console.main.click();
  await console.reaches("Running");
  await vehicle.getByText("this run", { exact: true }).waitFor();
  await vehicle.getByText("Ready", { exact: true }).waitFor();
  // Beside its mark and what it follows, a name is read whole.
  for (const width of [390, 1920]) {
    await console.page.setViewportSize({ width, height: 1080 });
    const names = (await console.panel("Robots")).locator(".swatch + .ellipsis");
    await names.first().waitFor();
    expect(await names.evaluateAll((all) => all.filter((one) => one.scrollWidth > one.clientWidth).length)).toBe(0);
  }
  await console.panel("Selection");
  await console.stop.click();
  await vehicle.getByText("Emergency stop", { exact: true }).waitFor();
  await console.button("Release the stop").first().click();
});
