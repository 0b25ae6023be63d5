// Lines above the canvas: the connection is lost, the file changed on disk, the text does not parse, something went wrong.

import { create } from "@bufbuild/protobuf";
import { useEffect } from "react";
import { Banner } from "../../ui/controls/banner.tsx";
import { Button, IconButton } from "../../ui/controls/controls.tsx";
import { Icon } from "../../ui/controls/icons.tsx";
import { useSecondsUntil } from "../../ui/controls/use_seconds.ts";
import { ChangedFile } from "../../ui/files/changed_file.tsx";
import { sentence, withoutBackticks } from "../../ui/words/sentence.ts";
import { crumbsIn } from "../session/crumbs.ts";
import type { Designer } from "../session/designer.ts";
import { save } from "../session/documents.ts";
import { isEmptyDrawing, isOfLibrary } from "../session/pages.ts";
import { type Document, type FileChanged, PageSchema } from "../session/protocol.ts";
import { type State, withoutChangedFile } from "../session/state.ts";
import { nameOf } from "../session/titles.ts";
import { useDesigner, useDocument, useDrawing, usePart } from "../session/use.ts";

/** What stays as long as the page does, or stops all work. */
export function Banners() {
  return (
    <>
      <LinkBanner />
      <NotKeptBanner />
      <ReadOnlyBanner />
    </>
  );
}

/** What comes and goes while somebody works: over the drawing, which must not move under the pointer. */
export function FloatingBanners() {
  const { over = [] } = useDesigner().extensions;
  return (
    <div className="floating-banners">
      {over.map((Over) => (
        <Over key={Over.displayName ?? Over.name} />
      ))}
      <ChangedBanner />
      <OutdatedBanner />
      <NoticeBanner />
    </div>
  );
}

function LinkBanner() {
  const designer = useDesigner();
  const link = usePart((state) => state.link);
  const hello = usePart((state) => state.hello);
  const seconds = useSecondsUntil(link.retryAt);
  if (link.state === "open" || (link.state === "connecting" && !hello)) return null;
  const isRefused = link.state === "refused";
  return (
    <Banner tone={isRefused ? "danger" : "hold"} role="alert">
      <Icon name="warning" />
      <span className="grow">
        {isRefused
          ? `The server refuses this page: ${link.reason}. Open the address that mlab has printed; what was not saved is kept there.`
          : `Connection lost: ${link.reason}. Nothing can be changed until it is back; what you did is kept by the server.`}
      </span>
      {!isRefused && (
        <>
          <span className="number">{seconds > 0 ? `again in ${seconds} s` : "connecting…"}</span>
          <Button onPress={() => designer.link.connect()}>Try now</Button>
        </>
      )}
    </Banner>
  );
}

function NotKeptBanner() {
  const designer = useDesigner();
  const notKept = usePart((state) => state.notKept);
  const isDirty = usePart((state) => Object.values(state.documents).some((document) => document.isDirty));
  const canSave = useDocument()?.isDirty === true;
  if (!notKept) return null;
  return (
    <Banner tone={isDirty ? "danger" : "hold"} role="alert">
      <Icon name="warning" />
      <span className="grow">
        What is not saved is not kept, and is lost when mlab ends: {withoutBackticks(notKept)}.
        {isDirty ? " There is something that is not saved." : ""}
      </span>
      {canSave && <Button onPress={() => void save(designer)}>Save</Button>}
    </Banner>
  );
}

function ChangedBanner() {
  const designer = useDesigner();
  const document = useDocument();
  const changed = usePart((state) => state.changed[state.document]);
  if (!document || !changed) return null;
  const dismiss = () => forget(designer, changed);
  const reload = async (merge: boolean) => {
    const answer = await designer.ask({ case: "reload", value: { document: document.path, merge } });
    if (answer.ok) dismiss();
  };
  const keep = async () => {
    if (await save(designer, true)) dismiss();
  };
  return (
    <ChangedFile
      name={nameOf(document)}
      what={changed.isGone ? "gone" : changed.isDirtyHere ? "both" : "taken"}
      onMerge={() => void reload(true)}
      onTakeTheirs={() => void reload(false)}
      onKeepMine={() => void keep()}
      onDismiss={dismiss}
    />
  );
}

function forget(designer: ReturnType<typeof useDesigner>, { document }: FileChanged): void {
  designer.store.setState(({ changed }) => ({ changed: withoutChangedFile(changed, document) }));
}

function ReadOnlyBanner() {
  const designer = useDesigner();
  const document = useDocument();
  const from = useCaller();
  if (!document?.isReadOnly) return null;
  return (
    <Banner tone="accent">
      <Icon name="lock" />
      <span className="grow">
        {isOfLibrary(document.path)
          ? "A component of the library: look, but not change."
          : "An example: look, or save it as your own."}
      </span>
      {from && (
        <Button tone="primary" onPress={() => void copyInto(designer, from)}>
          Make my own copy in {nameOf(from)}
        </Button>
      )}
      <Button onPress={() => designer.store.setState({ dialog: "save-as" })}>
        {from ? "Save the file as my own…" : "Make my own copy…"}
      </Button>
    </Banner>
  );
}

/** The document from which somebody looked inside of this component, where it may be changed. */
function useCaller(): Document | undefined {
  return usePart(callerOf);
}

function callerOf(state: State): Document | undefined {
  if (!isOfLibrary(state.document) || state.page === "" || state.page.includes(".")) return undefined;
  const before = crumbsIn(state).at(-2);
  const document = before && state.documents[before.document];
  return document && document.path !== state.document && !document.isReadOnly ? document : undefined;
}

/** The component that is shown becomes one of that document, which uses it from now on, and is shown there. */
async function copyInto(designer: Designer, into: Document): Promise<void> {
  const component = designer.state.page;
  const caller = crumbsIn(designer.state).at(-2);
  const answer = await designer.ask({
    case: "edit",
    value: {
      document: into.path,
      revision: into.revision,
      name: `own copy of ${component}`,
      changes: [{ change: { case: "copyComponent", value: { component, name: "" } } }],
    },
  });
  if (!answer.ok) return;
  designer.say(`${component} is a part of ${nameOf(into)} now, and can be changed`);
  designer.navigation.goTo(into.path, caller?.page ?? "");
  designer.navigation.enter(create(PageSchema, { document: into.path, path: component }));
}

function OutdatedBanner() {
  const designer = useDesigner();
  const document = useDocument();
  const drawing = useDrawing();
  if (!document?.isOutdated || !drawing || isEmptyDrawing(drawing)) return null; // the canvas itself says so
  return (
    <Banner tone="hold">
      <Icon name="warning" />
      <span className="grow">
        The text can't be read as it stands. The drawing is that of the last text that could.
      </span>
      <Button onPress={() => designer.show({ problems: true, text: true })}>Show why</Button>
    </Banner>
  );
}

function NoticeBanner() {
  const designer = useDesigner();
  const notice = usePart((state) => state.notice);
  useEffect(() => {
    if (!notice || notice.tone === "danger") return;
    const timer = setTimeout(() => designer.store.setState({ notice: null }), notice.action ? 20000 : 6000);
    return () => clearTimeout(timer);
  }, [notice, designer]);
  if (!notice) return null;
  return (
    <Banner tone={notice.tone} role="alert">
      <Icon name="warning" />
      <span className="grow">{sentence(notice.text, withoutBackticks)}</span>
      {notice.action && <Button onPress={notice.action.run}>{notice.action.label}</Button>}
      <IconButton icon="close" label="Dismiss" onPress={() => designer.store.setState({ notice: null })} />
    </Banner>
  );
}
