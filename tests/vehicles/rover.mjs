// A rover that speaks MAVLink 2 as ArduPilot's does, by an implementation of the protocol that is not ours.
//
//   node rover.mjs FOLDER PORT SPEED [key=PASSPHRASE] [obstacle=METRES] [NAME=VALUE ...]
//
// FOLDER has node_modules in it. Sends to PORT of this machine and hears what comes back; its time runs SPEED times as fast as
// the machine's. To its right it sees something all the time, 2.5 m away or as said; 0: nothing. NAME=VALUE sets one of its
// parameters. Says `ready` once it sends. Each line of its standard input is done (`mode NUMBER`, `disarm`, `shift METRES`,
// anything else) and answered by a line of JSON: what it was asked, and what it is doing.
import { createSocket } from "node:dgram";
import { createRequire } from "node:module";
import { createInterface } from "node:readline";

const [folder, port, speedUp, ...settings] = process.argv.slice(2);
const require = createRequire(`${folder}/`);
const { MavLinkPacketParser, MavLinkPacketSignature, MavLinkPacketSplitter, MavLinkProtocolV2, ardupilotmega, common, minimal, standard } =
  require("node-mavlink");

const registry = { ...minimal.REGISTRY, ...common.REGISTRY, ...ardupilotmega.REGISTRY };
const HOLD = 4;
const GUIDED = 15;
const acceleration = 2; // [m/s^2]
const step = 0.02; // [s]

const parameters = {
  FS_GCS_ENABLE: 1,
  FS_ACTION: 2,
  FS_TIMEOUT: 5,
  SYSID_MYGCS: 255,
  GUID_TIMEOUT: 1.5,
  FS_EKF_ACTION: 1,
  FS_CRASH_CHECK: 1,
};
let key = null;
let obstacle = 2.5;
for (const one of settings) {
  const [name, value] = one.split("=");
  if (name === "key") key = MavLinkPacketSignature.key(value);
  else if (name === "obstacle") obstacle = Number(value);
  else parameters[name] = Number(value);
}

const began = performance.now();
const now = () => ((performance.now() - began) / 1000) * Number(speedUp) + 1;
// What it counts its patience by: where the machine gives it no time, this waits, too, so that what has come meanwhile counts.
let lived = 0;
const rover = { mode: 0, armed: false, critical: false, north: 0, east: 0, yaw: 0, speed: 0, yawRate: 0, wanted: 0, forced: 0, stoodAt: 0 };
const heard = { station: null, setPoint: null, setPoints: 0, refused: 0, signedAt: 0 };
const intervals = new Map([[minimal.Heartbeat.MSG_ID, 1]]);
const sentAt = new Map();

const socket = createSocket("udp4");
const protocol = new MavLinkProtocolV2(1, 1);
const signer = new MavLinkProtocolV2(1, 1, MavLinkProtocolV2.IFLAG_SIGNED);
let sequence = 0;
let signedAt = 0;

function send(type, fields) {
  const message = Object.assign(new type(), fields);
  let bytes = (key ? signer : protocol).serialize(message, sequence++ & 255);
  // Times of signatures grow by a tenth of a millisecond at least.
  signedAt = Math.max(Date.now(), signedAt + 0.1);
  if (key) bytes = signer.sign(bytes, 1, key, signedAt);
  socket.send(bytes, Number(port), "127.0.0.1");
}

function isAccepted(packet) {
  if (!key) return true;
  const signature = packet.signature;
  const isGood = signature !== null && signature.matches(key) && signature.timestamp > heard.signedAt;
  if (isGood) heard.signedAt = signature.timestamp;
  else heard.refused++;
  return isGood;
}

const commands = {
  176: (message) => {
    rover.mode = message._param2;
    heard.setPoint = null;
    return 0;
  },
  400: (message) => {
    if (message._param1 === 1 && rover.mode !== GUIDED) return 4;
    if (message._param1 === 0 && message._param2 === 21196) rover.forced++;
    rover.armed = message._param1 === 1;
    return 0;
  },
  511: (message) => {
    if (message._param1 === common.DistanceSensor.MSG_ID) return 3;
    intervals.set(message._param1, message._param2 / 1e6);
    return 0;
  },
  512: (message) => {
    if (message._param1 !== standard.AutopilotVersion.MSG_ID) return 3;
    const flightCustomVersion = [...Buffer.from("9c2f1e4a")];
    send(standard.AutopilotVersion, { capabilities: 0n, uid: 0n, flightSwVersion: 0x040507ff, middlewareSwVersion: 0, osSwVersion: 0, boardVersion: 0, vendorId: 0, productId: 0, flightCustomVersion, middlewareCustomVersion: Array(8).fill(0), osCustomVersion: Array(8).fill(0), uid2: Array(18).fill(0) });
    return 0;
  },
};

function answerParameter(name) {
  if (!(name in parameters)) return;
  send(common.ParamValue, { paramId: name, paramValue: parameters[name], paramType: 9, paramCount: 7, paramIndex: 0 });
}

const takers = {
  [minimal.Heartbeat.MSG_ID]: (message, header) => {
    if (header.sysid === parameters.SYSID_MYGCS && message.type === 6) heard.station = lived;
  },
  [common.CommandLong.MSG_ID]: (message) => {
    const result = commands[message.command]?.(message) ?? 3;
    send(common.CommandAck, { command: message.command, result, progress: 0, resultParam2: 0, targetSystem: 255, targetComponent: 190 });
  },
  [common.ParamRequestRead.MSG_ID]: (message) => answerParameter(message.paramId),
  [common.ParamSet.MSG_ID]: (message) => {
    if (message.paramId in parameters) parameters[message.paramId] = message.paramValue;
    answerParameter(message.paramId);
  },
  [common.SetPositionTargetLocalNed.MSG_ID]: (message) => {
    heard.setPoints++;
    // Position, acceleration and yaw are to be ignored, velocity and turn rate not.
    if (rover.mode !== GUIDED || message.typeMask !== 0x05e7 || message.coordinateFrame !== 8) return;
    heard.setPoint = lived;
    rover.wanted = Math.sign(message.vx) * Math.hypot(message.vx, message.vy);
    rover.yawRate = message.yawRate;
  },
};

const splitter = new MavLinkPacketSplitter();
const parser = splitter.pipe(new MavLinkPacketParser());
parser.on("data", (packet) => {
  const taker = takers[packet.header.msgid];
  if (!taker || !isAccepted(packet)) return;
  const message = packet.protocol.data(packet.payload, registry[packet.header.msgid]);
  if ((message.targetSystem ?? 1) === 1) taker(message, packet.header);
});
socket.on("message", (bytes) => splitter.write(bytes));

function move() {
  const isTold = rover.mode === GUIDED && heard.setPoint !== null && lived - heard.setPoint <= parameters.GUID_TIMEOUT;
  const wanted = rover.armed && isTold ? rover.wanted : 0;
  if (!rover.armed || !isTold) rover.yawRate = 0;
  const change = Math.max(-acceleration * step, Math.min(acceleration * step, wanted - rover.speed));
  rover.speed = Math.abs(wanted - rover.speed) < 1e-9 ? wanted : rover.speed + change;
  if (rover.speed === 0 && change !== 0) rover.stoodAt = lived;
  rover.north += rover.speed * Math.cos(rover.yaw) * step;
  rover.east += rover.speed * Math.sin(rover.yaw) * step;
  rover.yaw += rover.yawRate * step;
}

function watch() {
  const isAlone = heard.station !== null && lived - heard.station > parameters.FS_TIMEOUT;
  rover.critical = rover.armed && isAlone && parameters.FS_GCS_ENABLE > 0;
  if (rover.critical) rover.mode = HOLD;
}

const boot = () => Math.round(now() * 1000);
const streams = [
  [minimal.Heartbeat, () => ({ customMode: rover.mode, type: 10, autopilot: 3, baseMode: 1 + (rover.armed ? 128 : 0), systemStatus: rover.critical ? 5 : rover.armed ? 4 : 3, mavlinkVersion: 3 })],
  [common.Attitude, () => ({ timeBootMs: boot(), roll: 0.01, pitch: 0, yaw: Math.atan2(Math.sin(rover.yaw), Math.cos(rover.yaw)), rollspeed: 0, pitchspeed: 0, yawspeed: rover.yawRate })],
  [common.LocalPositionNed, () => ({ timeBootMs: boot(), x: rover.north, y: rover.east, z: 0, vx: rover.speed * Math.cos(rover.yaw), vy: rover.speed * Math.sin(rover.yaw), vz: 0 })],
  [common.GlobalPositionInt, () => ({ timeBootMs: boot(), lat: 490000000, lon: 83000000, alt: 110000, relativeAlt: 0, vx: 0, vy: 0, vz: 0, hdg: 0 })],
  [common.SysStatus, () => ({ onboardControlSensorsPresent: 0x10000000, onboardControlSensorsEnabled: 0x10000000, onboardControlSensorsHealth: 0x10000000, load: 100, voltageBattery: 12600, currentBattery: 100, batteryRemaining: 77 })],
  [common.ObstacleDistance, () => ({ timeUsec: BigInt(boot()) * 1000n, sensorType: 0, distances: Array.from({ length: 72 }, (_, i) => (i === 18 && obstacle > 0 ? obstacle * 100 : 1001)), increment: 5, minDistance: 20, maxDistance: 1000, incrementF: 0, angleOffset: 0, frame: 12 })],
];

function stream() {
  for (const [type, fields] of streams) {
    const interval = intervals.get(type.MSG_ID);
    if (interval === undefined || now() - (sentAt.get(type.MSG_ID) ?? -1) < interval) continue;
    sentAt.set(type.MSG_ID, now());
    send(type, fields());
  }
}

let stepped = now();
setInterval(() => {
  stepped = Math.max(stepped, now() - 0.2);
  for (; stepped < now(); stepped += step) {
    lived += step;
    move();
    watch();
  }
  stream();
}, 2);

createInterface({ input: process.stdin }).on("line", (line) => {
  const [word, value] = line.split(" ");
  if (word === "mode") rover.mode = Number(value);
  if (word === "disarm") rover.armed = false;
  if (word === "shift") rover.north += Number(value);
  console.log(JSON.stringify({ ...rover, ...parameters, setPoints: heard.setPoints, refused: heard.refused, time: lived, asked: line }));
}).on("close", () => process.exit(0));
socket.bind(0, "127.0.0.1", () => console.log("ready"));
