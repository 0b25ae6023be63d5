// What can't be taken back is asked once.
import type { ReactNode } from "react";
import { Button } from "./controls.tsx";
import { DialogBox } from "./menus.tsx";

interface ConfirmProps {
  title: string;
  children: ReactNode;
  /** On the button that leaves everything as it is. */
  no: string;
  yes: string;
  onYes: () => void;
  onClose: () => void;
  isDisabled?: boolean;
  width?: number;
  /** `no` has the focus. */
  isCareful?: boolean;
}

export function Confirm(props: ConfirmProps) {
  const { title, children, no, yes, onYes, onClose, isDisabled = false, width, isCareful = false } = props;
  return (
    <DialogBox
      title={title}
      onClose={onClose}
      {...(width ? { width } : {})}
      footer={
        <>
          <Button autoFocus={isCareful} onPress={onClose}>
            {no}
          </Button>
          <Button
            tone="danger"
            isDisabled={isDisabled}
            onPress={() => {
              onClose();
              onYes();
            }}
          >
            {yes}
          </Button>
        </>
      }
    >
      {children}
    </DialogBox>
  );
}
