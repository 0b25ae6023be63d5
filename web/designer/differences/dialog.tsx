// With what a configuration is compared: the saved file, a revision of git, another file.
import { useCallback, useEffect, useState } from "react";
import { Button } from "../../ui/controls/controls.tsx";
import { DialogBox } from "../../ui/controls/menus.tsx";
import { FileList, type FolderListing } from "../../ui/files/file_list.tsx";
import { compareWith } from "../session/documents.ts";
import type { Request, RevisionList_Revision } from "../session/protocol.ts";
import { isNew } from "../session/titles.ts";
import { useDesigner, useDocument } from "../session/use.ts";

type With = NonNullable<Extract<Request, { case: "compareWith" }>["value"]["with"]>;

export function CompareDialog() {
  const designer = useDesigner();
  const document = useDocument();
  const [folder, setFolder] = useState("");
  const [refusal, setRefusal] = useState("");
  const revisions = useRevisions(document?.path ?? "");
  const list = useCallback(
    async (of: string): Promise<FolderListing> => {
      const { ok, error, result } = await designer.link.ask({ case: "listFiles", value: { folder: of } });
      const entries = result.case === "files" ? result.value.entries : [];
      return {
        problem: ok ? "" : error,
        entries: entries.filter((entry) => entry.isFolder || entry.path.endsWith(".cdl")),
      };
    },
    [designer],
  );
  const close = () => designer.store.setState({ dialog: "" });
  if (!document) return null;
  const compare = async (what: With) => {
    const refused = await compareWith(designer, what);
    if (refused) setRefusal(refused);
    else close();
  };
  return (
    <DialogBox title="Compare with" onClose={close} footer={<Button onPress={close}>Cancel</Button>}>
      {refusal && <p className="notice danger">{refusal}</p>}
      <Button autoFocus isDisabled={isNew(document.path)} onPress={() => void compare({ case: "saved", value: true })}>
        The saved file
      </Button>
      <section aria-label="Revisions of git">
        <h3>Revisions of git</h3>
        {typeof revisions === "string" ? (
          <p className="help">{revisions}</p>
        ) : (
          <ul className="revisions">
            {revisions.map((one) => (
              <li key={one.id}>
                <Button tone="quiet" onPress={() => void compare({ case: "revision", value: one.id })}>
                  <span className="number">{one.date}</span>
                  <span className="ellipsis">{one.subject}</span>
                  <span className="muted small ellipsis">{one.author}</span>
                </Button>
              </li>
            ))}
          </ul>
        )}
      </section>
      <section aria-label="Another file">
        <h3>Another file</h3>
        <FileList
          folder={folder}
          onFolder={setFolder}
          chosen=""
          onChoose={(path) => void compare({ case: "file", value: path })}
          onOpen={(path) => void compare({ case: "file", value: path })}
          isSelectable={() => true}
          list={list}
        />
      </section>
    </DialogBox>
  );
}

/** The last ones that touched the file; a sentence: why there are none. */
function useRevisions(path: string): readonly RevisionList_Revision[] | string {
  const designer = useDesigner();
  const [found, setFound] = useState<readonly RevisionList_Revision[] | string>("Asking git…");
  useEffect(() => {
    let isLeft = false;
    void designer.link.ask({ case: "listRevisions", value: { document: path } }).then((answer) => {
      if (isLeft) return;
      const all = answer.result.case === "revisions" ? answer.result.value.revisions : [];
      if (!answer.ok) setFound(`${answer.error[0]?.toUpperCase()}${answer.error.slice(1)}.`);
      else setFound(all.length > 0 ? all : "No revision of git has this file yet.");
    });
    return () => {
      isLeft = true;
    };
  }, [designer, path]);
  return found;
}
