// Colours for MDL and ODL: enough to read by; what is right or wrong, the server says.
import { LanguageSupport, StreamLanguage, type StreamParser } from "@codemirror/language";

const kMdlWords =
  words(`MISSION NAME ROBOTS COMMAND LIST HEADING FREEZE IMMEDIATE CONSOLE-DATABASE CONSOLE-DB ROBOT-INFO
  NAVIGATION PLANNED REACTIVE STATIONS ASSIGNED RANK COHESION
  // [[table mdl_word_string]]
  SCENARIO OVERLAY MISSION-AREA LOAD-MAP SP UNIT HEIGHTMAP NEW-ROBOT CREATE-OBSTACLES OBSTACLE QUIT SET PRINT
  FAILSAFE INJECTTRACK
  AND FORMATION TECHNIQUE SPEED PHASE-LINE UNTIL TIMEOUT ON-COMPLETION ACKNOWLEDGE ACK MESSAGE MSG WAIT
  SEED SYSTEM-SEED SHOW-TRAILS SHOW-ROBOT-TRAILS HIGHLIGHT-REPELLING-OBSTACLES SHOW-REPELLING-OBSTACLES
  USE-MILITARY-STYLE SHOW-MILITARY-STYLE SHOW-MOVEMENT-VECTORS SHOW-COLORMAP OBSTACLE-COVERAGE ZOOM-FACTOR
  SCALE-ROBOTS ROBOT-LENGTH MIN-OBSTACLE-RADIUS MAX-OBSTACLE-RADIUS CYCLE-DURATION FAILING-ROBOTS FAILURES-WITHIN
  DEBUG-ROBOTS DEBUG-SIMULATOR DEBUG-SCHEDULER
  // [[end]]
  `);
const kTasks = words(
  // [[table mdl_task_string]]
  "START MOVETO OCCUPY FOLLOW SWEEPTO RALLY TELEOPERATE TELOP VISIT SEARCH PATROL STOP QUIT",
  // [[end]]
);
const kValues = words(`TRAVELING TRAVELING-OVERWATCH BOUNDING-OVERWATCH ON OFF YES NO TRUE FALSE RED YELLOW ROBOT
  // [[table formation_string]]
  LINE LINE-LEFT LINE-RIGHT WEDGE WEDGE-LEFT WEDGE-RIGHT DIAMOND COLUMN SWEEP NO-FORMATION
  // [[end]]
  `);
const kOdlWords =
  words(`SCENARIO SITE ORIGIN GLOBAL_REF_POINT HEADING MISSION-AREA LOAD-MAP HEIGHTMAP SET ZOOM-FACTOR SCALE CONTROL
  MEASURES UTM GEO LAT LON CENTERLINE WIDTH EXTENTS ROUTE SPEED WAYPOINT-FILE`);
const kFeatures = words(
  // [[table odl_feature_string]]
  "AA PP ATK BP OBJ MINEFIELD LANDING-ZONE SP AXIS GAP BOUNDARY PL LDLC LD/LC ROAD WALL ROOM DOOR HALLWAY ATTRACTOR OBJECT BASKET FLAG OBSTACLE",
  // [[end]]
);
const kStyles = words("MOVABLE FIXED CONTAINER");

type Classes = readonly (readonly [ReadonlySet<string>, string])[];

export const kMdlParser = parser([
  [kTasks, "typeName"],
  [kMdlWords, "keyword"],
  [kValues, "atom"],
]);
export const kOdlParser = parser([
  [kFeatures, "typeName"],
  [kOdlWords, "keyword"],
  [kStyles, "atom"],
]);

export function mdl(): LanguageSupport {
  return new LanguageSupport(StreamLanguage.define(kMdlParser));
}

export function odl(): LanguageSupport {
  return new LanguageSupport(StreamLanguage.define(kOdlParser));
}

/** Both languages have the same words, only with other meanings: comments, strings, numbers, step labels, names. */
function parser(classes: Classes): StreamParser<unknown> {
  return {
    name: "mission text",
    languageData: { commentTokens: { line: "--" }, wordChars: "-" },
    token(stream) {
      if (stream.eatSpace()) return null;
      if (stream.match(/^--.*/)) return "comment";
      if (stream.match(/^"[^"]*"?/)) return "string";
      if (stream.match(/^\d[A-Za-z0-9]*\.(?=\s|$)/)) return "labelName";
      if (stream.match(/^[+-]?(\d+(:\d\d){1,2}|\d+\.?\d*(e[+-]?\d+)?|\.\d+)(?![A-Za-z_])/i)) return "number";
      const word = stream.match(/^[A-Za-z_][A-Za-z0-9_/-]*[*:]?/) as RegExpMatchArray | null;
      if (!word) {
        stream.next();
        return /[<>()=]/.test(stream.current()) ? "bracket" : null;
      }
      const upper = word[0].replace(/[*:]$/, "").toUpperCase();
      return classes.find(([known]) => known.has(upper))?.[1] ?? "variableName";
    },
  };
}

function words(text: string): ReadonlySet<string> {
  return new Set(text.split(/\s+/));
}
