// Open, new, save as: over the files of the project, which the server lists.
import { useCallback, useState } from "react";
import { Complete_Language, NewDocument_Kind } from "../../core/protocol.ts";
import { Button, Field } from "../../ui/controls/controls.tsx";
import { DialogBox } from "../../ui/controls/menus.tsx";
import { FileList, type FolderListing } from "../../ui/files/file_list.tsx";
import { OpenFileDialog } from "../../ui/files/open_dialog.tsx";
import { folderOf, join, nameOf, nameProblem, withEnding } from "../../ui/files/paths.ts";
import { openMission, order } from "../session/orders.ts";
import { usePart, useSession, useUi } from "../session/session.ts";

export function OpenDialog() {
  const session = useSession();
  const project = usePart("project");
  return (
    <OpenFileDialog
      title="Open a mission"
      first={folderOf(inProject(project?.mission ?? ""))}
      list={useListing()}
      isSelectable={(entry) => entry.kind === "mission"}
      open={(path) => openMission(session, path)}
      onClose={() => session.ui.set("dialog", "")}
      help="What is not saved of the open mission stays as a draft."
    />
  );
}

function useListing(): (folder: string) => Promise<FolderListing> {
  const { connection } = useSession();
  return useCallback(
    async (folder) => {
      const { ok, error, result } = await connection.ask({ case: "listFiles", value: { folder } });
      return { problem: ok ? "" : error, entries: result.case === "files" ? result.value.entries : [] };
    },
    [connection],
  );
}

export function NewMissionDialog() {
  const session = useSession();
  const [folder, setFolder] = useState("");
  const [name, setName] = useState("mission");
  const [kind, setKind] = useState(NewDocument_Kind.MISSION);
  const list = useListing();
  const close = () => session.ui.set("dialog", "");
  const problem = nameProblem(name);
  const path = join(folder, withEnding(name, kind === NewDocument_Kind.MISSION ? ".mdl" : ".odl"));
  const create = async () => {
    const reply = await order(session, { case: "newDocument", value: { kind, path } });
    if (reply.ok) close();
  };
  const hasMission = (session.model.get("project")?.mission ?? "") !== "";
  return (
    <DialogBox
      title={kind === NewDocument_Kind.MISSION ? "New mission" : "New overlay"}
      onClose={close}
      footer={
        <>
          <Button onPress={close}>Cancel</Button>
          <Button tone="primary" isDisabled={problem !== undefined} onPress={() => void create()}>
            Create
          </Button>
        </>
      }
    >
      {hasMission && (
        <div className="columns">
          <Button
            tone={kind === NewDocument_Kind.MISSION ? "primary" : "plain"}
            onPress={() => setKind(NewDocument_Kind.MISSION)}
          >
            A mission with its map
          </Button>
          <Button
            tone={kind === NewDocument_Kind.OVERLAY ? "primary" : "plain"}
            onPress={() => setKind(NewDocument_Kind.OVERLAY)}
          >
            An overlay for this mission
          </Button>
        </div>
      )}
      <Field
        label="Name"
        value={name}
        onChange={setName}
        problem={name === "" ? undefined : problem}
        autoFocus
        help={`Becomes ${path}`}
      />
      <FileList
        folder={folder}
        onFolder={setFolder}
        chosen=""
        onChoose={() => {}}
        onOpen={() => {}}
        isSelectable={() => false}
        list={list}
      />
    </DialogBox>
  );
}

export function SaveAsDialog() {
  const session = useSession();
  const documents = usePart("documents")?.documents ?? [];
  const shown = useUi("document");
  const document = documents.find((one) => one.path === shown) ?? documents[0];
  const before = inProject(document?.path ?? "");
  const list = useListing();
  const [folder, setFolder] = useState(folderOf(before));
  const [name, setName] = useState(nameOf(before) || nameOf((document?.path ?? "").replace(/^examples:/, "")));
  const close = () => session.ui.set("dialog", "");
  if (!document) return null;
  const ending = document.language === Complete_Language.OVERLAY ? ".odl" : ".mdl";
  const path = join(folder, withEnding(name, ending));
  const problem = nameProblem(name);
  const saveAs = async () => {
    const reply = await order(session, { case: "saveDocuments", value: { documents: [document.path], as: path } });
    if (reply.ok) close();
  };
  return (
    <DialogBox
      title={`Save ${nameOf(document.path)} as`}
      onClose={close}
      footer={
        <>
          <Button onPress={close}>Cancel</Button>
          <Button tone="primary" isDisabled={problem !== undefined} onPress={() => void saveAs()}>
            Save
          </Button>
        </>
      }
    >
      {document.isReadOnly && <p className="notice">Examples stay as they are: this saves a copy in your project.</p>}
      <Field label="Name" value={name} onChange={setName} problem={problem} autoFocus help={`Becomes ${path}`} />
      <FileList
        folder={folder}
        onFolder={setFolder}
        chosen=""
        onChoose={(chosen) => setName(nameOf(chosen))}
        onOpen={() => {}}
        isSelectable={(entry) => entry.kind !== "picture"}
        list={list}
      />
    </DialogBox>
  );
}

/** Examples are outside of the project. */
function inProject(path: string): string {
  return path.startsWith("examples:") ? "" : path;
}
