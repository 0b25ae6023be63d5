// What to do on a page on which nothing stands yet.
import { Button } from "../../ui/controls/controls.tsx";
import { askDevice } from "../palette/device_chooser.tsx";
import { isEmptyDrawing } from "../session/pages.ts";
import { type Drawing, Drawing_Kind } from "../session/protocol.ts";
import { useDesigner, useDocument, usePart } from "../session/use.ts";

function NewDeclarations() {
  const designer = useDesigner();
  const ask = (subject: string) => () => designer.store.setState({ dialog: "declaration", subject });
  return (
    <div className="columns" style={{ justifyContent: "center" }}>
      <Button tone="primary" icon="plus" onPress={ask("assemblage")}>
        New assemblage
      </Button>
      <Button icon="plus" onPress={ask("robot")}>
        New robot
      </Button>
      <Button icon="plus" onPress={ask("society")}>
        New society
      </Button>
    </div>
  );
}

/** An operator of societies that serves nothing yet. */
function NothingServed({ owner }: { owner: string }) {
  const designer = useDesigner();
  return (
    <div className="empty-hint">
      <h2>It serves nothing yet</h2>
      <p className="muted">
        Whatever it serves takes the place of the devices of the robots that it coordinates: which target each goes for,
        say.
      </p>
      <Button tone="primary" icon="plus" onPress={() => askDevice(designer, { owner, device: "", binds: "" })}>
        Serve a binding point
      </Button>
    </div>
  );
}

export function EmptyHint({ drawing }: { drawing: Drawing }) {
  const designer = useDesigner();
  const page = usePart((state) => state.page);
  const isOutdated = useDocument()?.isOutdated ?? false;
  if (!isEmptyDrawing(drawing)) return null;
  if (page !== "" && drawing.way.length === 0) {
    return (
      <div className="empty-hint">
        <h2>There is no {page}</h2>
        <p className="muted">It has gone from the file, or the text can't be read as it stands.</p>
        <Button tone="primary" icon="folder" onPress={() => designer.navigation.goTo(designer.state.document, "")}>
          The whole file
        </Button>
      </div>
    );
  }
  if (isOutdated) {
    return (
      <div className="empty-hint">
        <h2>Nothing can be drawn of this text</h2>
        <p className="muted">It can't be read as a configuration. The text says where, and what was expected there.</p>
        <Button tone="primary" icon="text" onPress={() => designer.show({ problems: true, text: true })}>
          Show why
        </Button>
      </div>
    );
  }
  if (drawing.isReadOnly) return null;
  if (drawing.kind === Drawing_Kind.OPERATOR) return <NothingServed owner={page} />;
  const isFile = drawing.kind === Drawing_Kind.FILE;
  return (
    <div className="empty-hint">
      <h2>{isFile ? "An empty configuration" : "An empty page"}</h2>
      <p className="muted">
        {isFile
          ? "Begin with an assemblage: a skill, put together out of behaviors. Robots and societies use it then."
          : "Drag components from the left, or press / and type what you look for."}
      </p>
      {isFile ? (
        <NewDeclarations />
      ) : (
        <Button tone="primary" icon="plus" onPress={() => designer.store.setState({ dialog: "place", placing: null })}>
          Place a component
        </Button>
      )}
    </div>
  );
}
