// Types of values in configurations and programs, and what is asked of them. `tools/tables` writes what stands between
// the marks from src/mlab/flow/value_types.h.

/** What flows in a wire, which gives the wire its colour. */
export type Flow = "movement" | "flag" | "number" | "percept" | "thing" | "text";

export interface ValueType {
  readonly name: string;
  readonly flow: Flow;
  /** A word of configurations for what a value means, `length`, in place of how it is kept, `double`. */
  readonly isQuantity?: true;
  /** A number without a fraction. */
  readonly isWhole?: true;
  /** Offered for parameters of assemblages. */
  readonly isForParameters?: true;
  /** Offered for what a sensor gives. */
  readonly isSensed?: true;
  /** How a value of it is typed, where nobody could guess it. */
  readonly format?: string;
}

/** In the order in which they are offered; a library may bring more. */
const kValueTypes: readonly ValueType[] = [
  // [[table value_type_rows]]
  { name: "gain", flow: "number", isQuantity: true, isForParameters: true },
  { name: "number", flow: "number", isQuantity: true, isForParameters: true },
  { name: "length", flow: "number", isQuantity: true, isForParameters: true },
  { name: "speed", flow: "number", isQuantity: true, isForParameters: true },
  { name: "angle", flow: "number", isQuantity: true, isForParameters: true },
  { name: "duration", flow: "number", isQuantity: true, isForParameters: true },
  { name: "turning", flow: "number", isQuantity: true, isForParameters: true },
  { name: "flag", flow: "flag", isQuantity: true, isForParameters: true },
  { name: "count", flow: "number", isQuantity: true, isWhole: true, isForParameters: true },
  { name: "text", flow: "text", isQuantity: true, isForParameters: true },
  { name: "object_class", flow: "thing", isQuantity: true, isForParameters: true },
  { name: "Obstacles", flow: "percept", isSensed: true },
  { name: "Robots", flow: "thing", isSensed: true },
  { name: "Objects", flow: "thing", isSensed: true },
  { name: "Object", flow: "thing", isForParameters: true, isSensed: true },
  { name: "Pose", flow: "percept", isSensed: true },
  { name: "Ranges", flow: "percept", isSensed: true },
  { name: "Vector", flow: "movement", isForParameters: true, isSensed: true, format: "ahead, left" },
  { name: "Point", flow: "percept", isForParameters: true, isSensed: true, format: "x, y" },
  { name: "Way", flow: "percept" },
  { name: "bool", flow: "flag", isSensed: true },
  { name: "double", flow: "number", isSensed: true },
  { name: "int", flow: "number", isWhole: true },
  { name: "ObjectClasses", flow: "thing" },
  { name: "Formation", flow: "percept" },
  { name: "FormationReference", flow: "percept" },
  { name: "Task", flow: "percept" },
  { name: "Text", flow: "text" },
  // [[end]]
  { name: "float", flow: "number" },
  // Of drawings and of other tools.
  { name: "Action", flow: "movement" },
  { name: "Movement", flow: "movement" },
  { name: "Boolean", flow: "flag" },
  { name: "Number", flow: "number" },
  { name: "Integer", flow: "number", isWhole: true },
];

const kByName = new Map(kValueTypes.map((type) => [type.name, type]));

export const kQuantityNames = namesOf(({ isQuantity }) => isQuantity);
export const kParameterTypeNames = namesOf(({ isForParameters }) => isForParameters);
export const kSensedTypeNames = namesOf(({ isSensed }) => isSensed);

/** In types of a library's own: what stands in the world. */
const kThings = /Object|Track|Robot|Door|Room|Sound|Mark/;

export function flowOf(type: string): Flow {
  const name = plainName(type);
  return kByName.get(name)?.flow ?? (kThings.test(name) ? "thing" : "percept");
}

export function isWholeNumber(type: string): boolean {
  return kByName.get(plainName(type))?.isWhole ?? false;
}

/** How a value of the type is typed; empty: as anybody would guess. */
export function formatOf(type: string): string {
  return kByName.get(type)?.format ?? "";
}

/** `list of Track` and `Track<3>` are about a Track. */
function plainName(type: string): string {
  return type
    .replace(/^(list of |const )/, "")
    .replace(/<.*>$/, "")
    .trim();
}

function namesOf(isWanted: (type: ValueType) => boolean | undefined): readonly string[] {
  return kValueTypes.filter(isWanted).map(({ name }) => name);
}
