// Open, save as, save to the library.
import { useCallback, useState } from "react";
import { Choice } from "../../ui/controls/choice.tsx";
import { Button, Field } from "../../ui/controls/controls.tsx";
import { DialogBox } from "../../ui/controls/menus.tsx";
import { FileList, type FolderListing } from "../../ui/files/file_list.tsx";
import { OpenFileDialog } from "../../ui/files/open_dialog.tsx";
import { folderOf, join, nameOf, nameProblem, withEnding } from "../../ui/files/paths.ts";
import { useFollowing } from "../session/follow.ts";
import { declarationOf } from "../session/pages.ts";
import type { Document } from "../session/protocol.ts";
import { nameOf as fileName, isNew } from "../session/titles.ts";
import { useDesigner, useDocument, usePart } from "../session/use.ts";

export function OpenDialog() {
  const designer = useDesigner();
  return (
    <OpenFileDialog
      title="Open a configuration"
      first={folderOf(inProject(designer.state.document))}
      list={useListing()}
      isSelectable={() => true}
      open={(path) => designer.navigation.open(path)}
      onClose={() => designer.store.setState({ dialog: "" })}
      help="What is not saved of the open ones is kept."
    />
  );
}

/** Folders and configurations. */
function useListing(): (folder: string) => Promise<FolderListing> {
  const designer = useDesigner();
  return useCallback(
    async (folder) => {
      const { ok, error, result } = await designer.link.ask({ case: "listFiles", value: { folder } });
      const entries = result.case === "files" ? result.value.entries : [];
      return {
        problem: ok ? "" : error,
        entries: entries.filter((entry) => entry.isFolder || entry.path.endsWith(".cdl")),
      };
    },
    [designer],
  );
}

export function SaveAsDialog() {
  const designer = useDesigner();
  const document = useDocument();
  const before = inProject(document?.path ?? "");
  const [folder, setFolder] = useState(folderOf(before));
  const [name, setName] = useFollowing(firstName(document));
  const [isThere, setIsThere] = useState(false);
  const [refusal, setRefusal] = useState("");
  const list = useListing();
  const close = () => designer.store.setState({ dialog: "" });
  if (!document) return null;
  const path = join(folder, withEnding(name, ".cdl"));
  const problem = nameProblem(name);
  const save = async () => {
    const answer = await designer.link.ask({
      case: "save",
      value: { document: document.path, as: path, overwrite: isThere },
    });
    if (!answer.ok) {
      setRefusal(answer.error);
      setIsThere(/^there is|changed by/.test(answer.error)); // only then does it help to insist
      return;
    }
    close();
    const saved = answer.result.case === "text" && answer.result.value !== "" ? answer.result.value : path;
    designer.say(`Saved ${saved}`);
  };
  return (
    <DialogBox
      title={`Save ${fileName(document)} as`}
      onClose={close}
      footer={
        <>
          <Button onPress={close}>Cancel</Button>
          <Button tone={isThere ? "danger" : "primary"} isDisabled={problem !== undefined} onPress={() => void save()}>
            {isThere ? "Replace it" : "Save"}
          </Button>
        </>
      }
    >
      {document.isReadOnly && <p className="notice">This stays as it is: what is saved is a copy of your own.</p>}
      {refusal && <p className="notice hold">{refusal}</p>}
      {/* Enter in the field is the button's, as long as that replaces nothing. */}
      <form
        onSubmit={(event) => {
          event.preventDefault();
          if (problem === undefined && !isThere) void save();
        }}
      >
        <Field
          label="Name"
          value={name}
          onChange={(next) => {
            setName(next);
            setIsThere(false);
            setRefusal("");
          }}
          problem={problem}
          autoFocus
          help={`Becomes ${path}`}
        />
      </form>
      <FileList
        folder={folder}
        onFolder={setFolder}
        chosen=""
        onChoose={(chosen) => setName(nameOf(chosen))}
        onOpen={() => {}}
        isSelectable={() => true}
        list={list}
      />
    </DialogBox>
  );
}

/** An assemblage goes to the project's own library, and so into the palette of every file. */
export function LibraryDialog() {
  const designer = useDesigner();
  const document = useDocument();
  const page = usePart((state) => state.page);
  const own = (document?.declarations ?? []).filter((one) => one.kind === "assemblage");
  const [name, setName] = useState(own.find((one) => one.name === declarationOf(page))?.name ?? own[0]?.name ?? "");
  const close = () => designer.store.setState({ dialog: "" });
  if (!document) return null;
  const save = async () => {
    const answer = await designer.ask({ case: "save", value: { document: document.path, library: name } });
    if (!answer.ok) return;
    close();
    designer.tell(
      `${name} is in the library now, and in the palette of every configuration of this project.`,
      "accent",
    );
  };
  return (
    <DialogBox
      title="Save to the library"
      onClose={close}
      footer={
        <>
          <Button onPress={close}>Cancel</Button>
          <Button tone="primary" isDisabled={name === ""} onPress={() => void save()}>
            Save to the library
          </Button>
        </>
      }
    >
      {own.length === 0 ? (
        <p className="notice">This file has no assemblage that could be saved.</p>
      ) : (
        <Choice
          label="Assemblage"
          value={name}
          choices={own.map((one) => [one.name, one.name, one.help])}
          onChange={setName}
        />
      )}
      <p className="help">
        With its documentation and its parameters. Other configurations of this project use it by its name.
      </p>
    </DialogBox>
  );
}

function firstName(document: Document | undefined): string {
  if (!document) return "";
  if (!isNew(document.path) || document.title.endsWith(".cdl")) return nameOf(fileName(document));
  const declaration = document.declarations[0]?.name ?? "";
  return declaration === "" ? "configuration" : declaration.replaceAll(/(?<=[a-z0-9])(?=[A-Z])/g, "_").toLowerCase();
}

/** Examples and the library are outside of the project. */
function inProject(path: string): string {
  return path.includes(":") ? "" : path;
}
