// A file that somebody else has changed while it is open here.
import { Banner } from "../controls/banner.tsx";
import { Button, IconButton } from "../controls/controls.tsx";
import { Icon } from "../controls/icons.tsx";

interface ChangedFileProps {
  /** As people call it. */
  name: string;
  /** `taken`: its new text is shown already; `both`: there is something unsaved here as well. */
  what: "taken" | "both" | "gone";
  onMerge: () => void;
  onTakeTheirs: () => void;
  /** Writes what is here over what is there. */
  onKeepMine: () => void;
  /** None: it stays until somebody has decided. */
  onDismiss?: (() => void) | undefined;
  /** Somebody else decides. */
  isWatching?: boolean;
}

const said = {
  taken: "was changed on the disk; this is the new text.",
  both: "was changed on the disk, and you have changes that are not saved.",
  gone: "is gone from the disk. Save writes it anew.",
};
const saidToWatchers = {
  taken: said.taken,
  both: "was changed on the disk, and there are changes that are not saved.",
  gone: "is gone from the disk.",
};

export function ChangedFile(props: ChangedFileProps) {
  const { name, what, onDismiss, isWatching = false } = props;
  const decides = what === "both" && !isWatching;
  return (
    <Banner tone={what === "taken" ? "accent" : "hold"} role={decides ? "alert" : "status"}>
      <Icon name="file" />
      <span className="grow">
        {name} {(isWatching ? saidToWatchers : said)[what]}
      </span>
      {what === "gone" && !isWatching && <Button onPress={props.onKeepMine}>Save</Button>}
      {decides && (
        <span className="banner-acts">
          <Button tone="primary" onPress={props.onMerge}>
            Merge both
          </Button>
          <Button onPress={props.onTakeTheirs}>Take the disk's</Button>
          <Button onPress={props.onKeepMine}>Keep mine</Button>
        </span>
      )}
      {what !== "both" && onDismiss && <IconButton icon="close" label="Dismiss" onPress={onDismiss} />}
    </Banner>
  );
}
