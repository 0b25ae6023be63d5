// A file of the project, to be opened.
import { useState } from "react";
import type { FileList_Entry } from "../../core/protocol.ts";
import { Button } from "../controls/controls.tsx";
import { DialogBox } from "../controls/menus.tsx";
import { FileList, type FolderListing } from "./file_list.tsx";

interface OpenFileProps {
  title: string;
  /** The folder that is shown first. */
  first: string;
  list: (folder: string) => Promise<FolderListing>;
  isSelectable: (entry: FileList_Entry) => boolean;
  /** Whether that could be done. */
  open: (path: string) => Promise<boolean>;
  onClose: () => void;
  help: string;
}

export function OpenFileDialog({ title, first, list, isSelectable, open, onClose, help }: OpenFileProps) {
  const [folder, setFolder] = useState(first);
  const [chosen, setChosen] = useState("");
  const openIt = async (path: string) => {
    if (await open(path)) onClose();
  };
  return (
    <DialogBox
      title={title}
      onClose={onClose}
      footer={
        <>
          <Button onPress={onClose}>Cancel</Button>
          <Button tone="primary" isDisabled={chosen === ""} onPress={() => void openIt(chosen)}>
            Open
          </Button>
        </>
      }
    >
      <FileList
        folder={folder}
        onFolder={(next) => {
          setFolder(next);
          setChosen("");
        }}
        chosen={chosen}
        onChoose={setChosen}
        onOpen={(path) => void openIt(path)}
        isSelectable={isSelectable}
        list={list}
      />
      <p className="help">{help}</p>
    </DialogBox>
  );
}
