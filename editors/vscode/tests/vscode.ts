/**
 * A stand-in for the module `vscode`, which exists only inside of VS Code. It has no behaviour of its own: it keeps what
 * the extension registers, so that a test can ask for it, and hands out texts. Everything else (the extension, its client
 * library, the language server) is the real one.
 */

type Listener = (event: unknown) => unknown;

class Emitter {
  readonly listeners: Listener[] = [];
  readonly event = (listener: Listener, self?: unknown) => {
    this.listeners.push(self === undefined ? listener : listener.bind(self));
    return new Disposable(() => undefined);
  };
  async fire(event: unknown): Promise<void> {
    for (const listener of this.listeners) await listener(event);
  }
  dispose(): void {}
}

class Disposable {
  constructor(private readonly end: () => void) {}
  static from(...all: { dispose(): void }[]): Disposable {
    return new Disposable(() => {
      for (const one of all) one.dispose();
    });
  }
  dispose(): void {
    this.end();
  }
}

export class Position {
  constructor(
    readonly line: number,
    readonly character: number,
  ) {}
}

export class Range {
  constructor(
    readonly start: Position,
    readonly end: Position,
  ) {}
}

export class Uri {
  private constructor(private readonly href: string) {}
  static parse(href: string): Uri {
    return new Uri(href);
  }
  static file(path: string): Uri {
    return new Uri(`file://${path}`);
  }
  get scheme(): string {
    return this.href.slice(0, this.href.indexOf(":"));
  }
  get fsPath(): string {
    return decodeURIComponent(this.href.slice("file://".length));
  }
  get path(): string {
    return this.fsPath;
  }
  toString(): string {
    return this.href;
  }
}

class CompletionItem {
  constructor(
    readonly label: string,
    public kind?: number,
  ) {}
}

class CompletionList {
  constructor(
    readonly items: CompletionItem[],
    readonly isIncomplete: boolean,
  ) {}
}

class CancellationTokenSource {
  readonly token = { isCancellationRequested: false, onCancellationRequested: new Emitter().event };
  cancel(): void {}
  dispose(): void {}
}

class Diagnostic {
  code: unknown;
  constructor(
    readonly range: Range,
    readonly message: string,
    readonly severity: number,
  ) {}
}

class CodeActionKind {
  static readonly Empty = new CodeActionKind("");
  static readonly QuickFix = new CodeActionKind("quickfix");
  constructor(readonly value: string) {}
  append(part: string): CodeActionKind {
    return new CodeActionKind(this.value === "" ? part : `${this.value}.${part}`);
  }
}

/** A class for each of the many that the client library derives its own from. */
function plainClass(name: string): unknown {
  const made = { [name]: class {} }[name]!;
  return made;
}

export interface StandIn {
  module: unknown;
  /** Providers by what registered them: `registerCompletionItemProvider`. */
  providers: Map<string, unknown[]>;
  diagnostics: Map<string, { message: string; code: unknown }[]>;
  errors: string[];
  open(uri: string, languageId: string, text: string): Promise<unknown>;
  command(name: string): Promise<unknown>;
}

export function standIn(settings: Record<string, unknown>, folder: string): StandIn {
  const providers = new Map<string, unknown[]>();
  const diagnostics = new Map<string, { message: string; code: unknown }[]>();
  const errors: string[] = [];
  const commands = new Map<string, (...all: unknown[]) => unknown>();
  const events = new Map<string, Emitter>();
  const textDocuments: unknown[] = [];
  const event = (name: string): Emitter => {
    const known = events.get(name) ?? new Emitter();
    events.set(name, known);
    return known;
  };

  // `onDid...` is an event, `register...` keeps a provider, anything else that is asked for does nothing.
  const space = (known: Record<string, unknown>): unknown =>
    new Proxy(known, {
      get: (target, name) => {
        if (typeof name !== "string" || name in target) return target[name as string];
        if (/^on(Did|Will)/.test(name)) return event(name).event;
        if (name.startsWith("register"))
          return (...all: unknown[]) => {
            providers.set(name, [...(providers.get(name) ?? []), all]);
            return new Disposable(() => undefined);
          };
        return undefined;
      },
    });

  const collection = {
    name: "missionlab",
    set: (uri: Uri, list: { message: string; code: unknown }[] | undefined) =>
      diagnostics.set(uri.toString(), list ?? []),
    delete: (uri: Uri) => diagnostics.delete(uri.toString()),
    clear: () => diagnostics.clear(),
    get: () => [],
    has: () => false,
    forEach: () => undefined,
    dispose: () => undefined,
  };
  const channel = new Proxy({ name: "missionlab", logLevel: 0 } as Record<string, unknown>, {
    get: (target, name) => {
      if (typeof name !== "string" || name in target) return target[name as string];
      return name.startsWith("on") ? new Emitter().event : () => undefined;
    },
  });

  const known: Record<string, unknown> = {
    Position,
    Range,
    Uri,
    Disposable,
    CodeActionKind,
    Diagnostic,
    CompletionItem,
    CompletionList,
    CancellationTokenSource,
    EventEmitter: Emitter,
    version: "1.100.0",
    env: space({ appName: "stand-in", language: "en", clipboard: {}, createTelemetryLogger: () => ({}) }),
    workspace: space({
      workspaceFolders: [{ uri: Uri.file(folder), name: "test", index: 0 }],
      textDocuments,
      notebookDocuments: [],
      isTrusted: true,
      getWorkspaceFolder: () => undefined,
      getConfiguration: (section?: string) => ({
        get: (name: string, otherwise: unknown) => settings[section ? `${section}.${name}` : name] ?? otherwise,
        has: () => false,
        inspect: () => undefined,
      }),
      createFileSystemWatcher: () => ({
        onDidCreate: new Emitter().event,
        onDidChange: new Emitter().event,
        onDidDelete: new Emitter().event,
        dispose: () => undefined,
      }),
      fs: {},
    }),
    languages: space({
      match: (selector: { language?: string }[], document: { languageId: string }) =>
        [selector].flat().some((one) => one.language === document.languageId) ? 10 : 0,
      createDiagnosticCollection: () => collection,
    }),
    window: space({
      visibleTextEditors: [],
      tabGroups: { all: [], onDidChangeTabs: new Emitter().event, onDidChangeTabGroups: new Emitter().event },
      createOutputChannel: () => channel,
      showErrorMessage: async (message: string) => {
        errors.push(message);
        return undefined;
      },
    }),
    commands: space({
      registerCommand: (name: string, run: (...all: unknown[]) => unknown) => {
        commands.set(name, run);
        return new Disposable(() => commands.delete(name));
      },
      executeCommand: async () => undefined,
    }),
  };
  const classes = new Map<string, unknown>();
  const module = new Proxy(known, {
    get: (target, name) => {
      if (typeof name !== "string" || name in target) return target[name as string];
      // So that nobody copies what is there already: the rest is made when it is asked for.
      if (name === "__esModule") return true;
      if (name === "default") return undefined;
      if (!/^[A-Z]/.test(name)) return space({});
      const made = classes.get(name) ?? plainClass(name);
      classes.set(name, made);
      return made;
    },
  });

  return {
    module,
    providers,
    diagnostics,
    errors,
    async open(uri, languageId, text) {
      const document = {
        uri: Uri.parse(uri),
        fileName: Uri.parse(uri).fsPath,
        languageId,
        version: 1,
        isClosed: false,
        isDirty: false,
        isUntitled: false,
        eol: 1,
        getText: () => text,
        lineCount: text.split("\n").length,
      };
      textDocuments.push(document);
      await event("onDidOpenTextDocument").fire(document);
      return document;
    },
    async command(name) {
      return commands.get(name)?.();
    },
  };
}
