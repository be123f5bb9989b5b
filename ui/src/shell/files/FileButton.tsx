import { useRef } from "preact/hooks";
import type { DriveFileSuffix } from "../../api/kiosk";
import type { AppearanceProps } from "../../kit/appearance";
import { Button } from "../../kit/Button";
import { settled } from "../../kit/report";
import { isKiosk } from "../kiosk";
import { driveRequest } from "./drive_request";

interface FileButtonProps extends AppearanceProps {
  accept: DriveFileSuffix;
  /** May return a promise; its failure is reported. */
  onFile(file: File): unknown;
}

/** A button that opens the file dialog, in kiosk mode the dialog of the drives. The test id is on the input. */
export function FileButton({ accept, testId, onFile, ...face }: FileButtonProps) {
  const input = useRef<HTMLInputElement>(null);
  const choose = () => {
    if (isKiosk()) driveRequest.value = { kind: "open", suffix: accept, onFile };
    else input.current?.click();
  };
  return (
    <>
      <input
        ref={input}
        type="file"
        accept={accept}
        hidden
        data-testid={testId}
        onChange={({ currentTarget }) => {
          const [file] = currentTarget.files ?? [];
          currentTarget.value = ""; // lets the user choose the same file again
          if (file) void settled(onFile(file));
        }}
      />
      <Button {...face} onPress={choose} />
    </>
  );
}
