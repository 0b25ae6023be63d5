// What BehaviorTree.CPP 4.7 to 4.9 refuses, by the rules of its own parser, in its order: reading the XML (tinyxml2),
// registering the nodes that the models declare, VerifyXML, and making the nodes. A tree that passes is given back.

const BUILT_IN = {
  Control:
    "Fallback AsyncFallback Sequence AsyncSequence SequenceWithMemory Parallel ParallelAll ReactiveSequence " +
    "ReactiveFallback IfThenElse WhileDoElse Switch2 Switch3 Switch4 Switch5 Switch6",
  Decorator:
    "Inverter RetryUntilSuccessful KeepRunningUntilFailure Repeat Timeout Delay RunOnce ForceSuccess ForceFailure " +
    "Precondition LoopInt LoopBool LoopDouble LoopString SkipUnlessUpdated WaitValueUpdate",
  Action: "AlwaysSuccess AlwaysFailure Script SetBlackboard Sleep UnsetBlackboard WasEntryUpdated",
  Condition: "ScriptCondition",
  SubTree: "SubTree",
};
// Ports of those that trees of ours have.
const PORTS = { Script: ["code"], ScriptCondition: ["code"] };
const KINDS = ["Action", "Condition", "Control", "Decorator", "SubTree"];
const CONDITIONS = ["_failureIf", "_successIf", "_skipIf", "_while", "_onHalted", "_onFailure", "_onSuccess", "_post"];
const isReserved = (name) => [...CONDITIONS, "name", "ID", "_autoremap"].includes(name);
const isPort = (name) => /^[A-Za-z]/.test(name) && !isReserved(name);

const refuse = (why) => {
  throw new Error(why);
};

export function parseXml(xml) {
  const entities = { "&amp;": "&", "&lt;": "<", "&gt;": ">", "&quot;": '"', "&apos;": "'" };
  const top = { tag: "", attributes: {}, children: [] };
  const open = [top];
  const part =
    /\s*(?:<\?[^>]*\?>|<!--[\s\S]*?-->|<\/([A-Za-z_:][\w.:-]*)\s*>|<([A-Za-z_:][\w.:-]*)((?:\s+[A-Za-z_:][\w.:-]*\s*=\s*(?:"[^"<]*"|'[^'<]*'))*)\s*(\/?)>)/y;
  let at = 0;
  for (; xml.slice(at).trim() !== ""; at = part.lastIndex) {
    part.lastIndex = at;
    const [whole, close, tag, inside, leaf] = part.exec(xml) ?? refuse(`Error parsing the XML at ${xml.slice(at, at + 40)}`);
    if (whole.trim().startsWith("<?") || whole.trim().startsWith("<!")) continue;
    if (close) {
      if (open.length < 2 || open.pop().tag !== close) refuse(`Error parsing the XML: </${close}> closes nothing`);
      continue;
    }
    const node = { tag, attributes: {}, children: [], at: 0 };
    for (const [, key, , value] of inside.matchAll(/([A-Za-z_:][\w.:-]*)\s*=\s*(["'])((?:(?!\2).)*)\2/gs)) {
      if (key in node.attributes) refuse(`Error parsing the XML: ${key} stands twice`);
      node.attributes[key] = value.replace(/&[#\w]+;/g, (entity) => entities[entity] ?? refuse(`Error parsing the XML: ${entity}`));
    }
    open.at(-1).children.push(node);
    if (!leaf) open.push(node);
  }
  if (open.length > 1) refuse(`Error parsing the XML: <${open.at(-1).tag}> is not closed`);
  return top.children[0];
}

// The factory, once a program has registered a node for every model.
function factoryOf(root) {
  const factory = new Map();
  for (const [kind, names] of Object.entries(BUILT_IN))
    for (const name of names.split(" ")) factory.set(name, { kind, ports: PORTS[name] ?? [] });
  for (const models of root.children.filter((one) => one.tag === "TreeNodesModel")) {
    for (const model of models.children) {
      const id = model.attributes.ID ?? refuse(`The attribute [ID] is mandatory in the model <${model.tag}>`);
      if (model.tag === "SubTree") continue;
      if (!KINDS.includes(model.tag)) refuse(`<${model.tag}> is no model`);
      if (factory.has(id)) refuse(`ID [${id}] already registered`);
      const ports = model.children.map((port) => port.attributes.name ?? refuse("Missing attribute [name] in port"));
      for (const port of ports) {
        if (!isPort(port))
          refuse(`The name of a port must not be \`name\` or \`ID\` and must start with an alphabetic character: ${port}`);
      }
      factory.set(id, { kind: model.tag, ports });
    }
  }
  return factory;
}

function verify(node, factory, treeCount) {
  const id = node.attributes.ID ?? "";
  const isKind = KINDS.includes(node.tag);
  const count = node.children.length;
  if (isKind && id === "") refuse(`The tag <${node.tag}> must have the attribute [ID]`);
  if (node.tag === "BehaviorTree") {
    if (id === "" && treeCount > 1) refuse("The tag <BehaviorTree> must have the attribute [ID]");
    if (factory.has(id)) refuse("The attribute [ID] of tag <BehaviorTree> must not use the name of a registered Node");
    if (count !== 1) refuse(`The tag <BehaviorTree> with ID '${id}' must have exactly 1 child`);
  } else if (node.tag === "SubTree") {
    if (count !== 0) refuse(`<SubTree> with ID '${id}' should not have any child`);
    if (factory.has(id)) refuse("The attribute [ID] of tag <SubTree> must not use the name of a registered Node");
  } else {
    const name = isKind ? id : node.tag;
    const { kind } = factory.get(name) ?? refuse(`Node not recognized: ${name}`);
    if (kind === "Decorator" && count !== 1) refuse(`The node '${name}' must have exactly 1 child`);
    if (kind === "Control" && count === 0) refuse(`The node '${name}' must have 1 or more children`);
    if ((kind === "Action" || kind === "Condition") && count !== 0) refuse(`The node '${name}' must not have any child`);
    // Looked up by the element's own name: here the form <Action ID="..."/> is not known. The library asks that of the
    // children of reactive sequences; we of those of all control nodes, for all are written alike.
    for (const child of kind === "Control" ? node.children : [])
      if (!factory.has(child.tag)) refuse(`Unknown node type: ${child.tag}`);
  }
  for (const child of node.children) verify(child, factory, treeCount);
}

function create(node, factory) {
  const isKind = KINDS.includes(node.tag);
  if (!isKind && "ID" in node.attributes) refuse(`Attribute [ID] is not allowed in <${node.tag}>`);
  const type = isKind ? node.attributes.ID : node.tag;
  const { ports } = factory.get(type);
  for (const name of Object.keys(node.attributes)) {
    if (isPort(name) && !ports.includes(name))
      refuse(`a port with name [${name}] is found in the XML (<${node.tag}>) but not in the providedPorts() of its registered node type.`);
    // Neither a port nor a condition: the library drops it without a word. What we write has a meaning.
    if (!isPort(name) && !isReserved(name)) refuse(`the attribute [${name}] would be dropped`);
  }
  if (node.tag === "Script" || node.tag === "ScriptCondition") checkScript(node.attributes.code ?? refuse("missing port [code]"));
  node.kind = factory.get(type).kind;
  node.type = type;
  for (const child of node.children) create(child, factory);
}

// Scripts: what they are made of. `true` and `false` are found in front of longer names, too.
function checkScript(code) {
  const token = /\s*(?:(true|false)|'([^']*)'|"[^"]*"|\d+(?:\.\d+)?|[A-Za-z_@]\w*|:=|==|!=|<=|>=|&&|\|\||[-+*/<>=!?:;()])/y;
  for (let at = 0; code.slice(at).trim() !== ""; at = token.lastIndex) {
    token.lastIndex = at;
    const found = token.exec(code) ?? refuse(`Error in the script "${code}"`);
    if (found[1] && /\w/.test(code[token.lastIndex] ?? "")) refuse(`Error in the script "${code}": ${found[1]}`);
    // biome-ignore lint/suspicious/noControlCharactersInRegex: the rule is about them
    if (found[2] && /[^\x00-\x7f]/.test(found[2])) refuse(`Error in the script "${code}"`);
  }
}

// Whether the value of a port is a name on the blackboard, and which.
export function pointer(port, value) {
  if (value === "=" || value === "{=}") return port;
  return /^ *\{(.+)\} *$/.exec(value)?.[1];
}

export function load(xml) {
  const root = parseXml(xml);
  if (root?.tag !== "root") refuse("The XML must have a root node called <root>");
  if (root.children.filter((one) => one.tag === "TreeNodesModel").length > 1)
    refuse("Only a single node <TreeNodesModel> is supported");
  if (root.attributes.BTCPP_format !== "4") refuse('<root> should contain the attribute [BTCPP_format="4"]');
  const factory = factoryOf(root);
  const trees = root.children.filter((one) => one.tag === "BehaviorTree");
  for (const tree of trees) verify(tree, factory, root.children.length);
  const main = root.attributes.main_tree_to_execute;
  if (main === undefined && trees.length !== 1) refuse("[main_tree_to_execute] was not specified correctly");
  const tree = trees.find((one) => main === undefined || one.attributes.ID === main) ?? refuse(`Can't find a tree with name: ${main}`);
  create(tree.children[0], factory);
  return tree.children[0];
}
