// What can be done, declared in tables: one row for each action, which says what it is, when it can't be done and why, and
// what it does. How things stand is asked when it is shown or done.
import type { IconName } from "../controls/icons.tsx";
import type { Command } from "./commands.tsx";

/** Why something can't be done now, as a sentence; nothing: it can. */
export type Hindrance<Context> = (context: Context) => string | undefined;

export interface ActionRow<Context> {
  readonly id: string;
  /** As in a menu. */
  readonly label: string | ((context: Context) => string);
  readonly icon?: IconName | ((context: Context) => IconName);
  /** As in keys.ts. */
  readonly shortcut?: string;
  /** Also while a text field has the focus. */
  readonly everywhere?: true;
  /** The first that has something to say is told. */
  readonly unless?: readonly Hindrance<Context>[];
  readonly run: (context: Context) => void;
}

/** Rows of one heading of menus and of the sheet of keys. */
export interface ActionTable<Context, Group extends string> {
  readonly group: Group;
  readonly rows: readonly ActionRow<Context>[];
}

export interface DeclaredAction<Group extends string> extends Command {
  group: Group;
  everywhere?: boolean;
}

/** How the actions of a table stand now. */
export function actionsOf<Context, Group extends string>(
  { group, rows }: ActionTable<Context, Group>,
  context: Context,
): DeclaredAction<Group>[] {
  return rows.map((row) => ({
    id: row.id,
    label: atPresent(row.label, context),
    group,
    ...(row.icon ? { icon: atPresent(row.icon, context) } : {}),
    ...(row.shortcut ? { shortcut: row.shortcut } : {}),
    ...(row.everywhere ? { everywhere: row.everywhere } : {}),
    blocked: hindranceOf(row, context),
    run: () => row.run(context),
  }));
}

function hindranceOf<Context>({ unless = [] }: ActionRow<Context>, context: Context): string | undefined {
  for (const hindrance of unless) {
    const why = hindrance(context);
    if (why !== undefined) return why;
  }
  return undefined;
}

function atPresent<Context, Word extends string>(word: Word | ((context: Context) => Word), context: Context): Word {
  return typeof word === "function" ? word(context) : word;
}
