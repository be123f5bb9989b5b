import { useSignal } from "@preact/signals";
import { FileText, HardDrive, RefreshCw, Save, Usb, X } from "lucide-preact";
import { useEffect, useRef } from "preact/hooks";
import { type DriveFileSuffix, kioskApi } from "../api/kiosk";
import type { Drive, DriveFile, SavedDriveFile } from "../api/model";
import { language, texts } from "../i18n";
import { relativeTime } from "../i18n/format";
import { Button } from "../kit/Button";
import { settled } from "../kit/report";
import { useAction } from "../kit/requests/action";
import { FaultLine } from "../kit/requests/FaultLine";
import { Loaded } from "../kit/requests/Loaded";
import { useLoaded } from "../kit/requests/useLoaded";
import { driveRequest } from "../shell/files/drive_request";
import { size } from "../teacher/exchange/size";

const close = () => {
  driveRequest.value = null;
};

/** Asks for a file on a drive, or for the drive to save one on: in place of the file dialogs of the system. */
export function DriveDialog() {
  const request = driveRequest.value;
  const { kiosk: labels } = texts.value;
  const dialog = useRef<HTMLDialogElement>(null);
  const suffix = request?.kind === "open" ? request.suffix : ".pinel";
  const action = useAction();
  const found = useLoaded(request, () => kioskApi.drives(suffix));
  useEffect(() => dialog.current?.showModal(), []);
  if (!request) return null;
  const title = request.kind === "open" ? labels.open : labels.save({ name: request.name });
  return (
    <dialog
      ref={dialog}
      class="drives card column gap-3"
      aria-labelledby="drives-title"
      data-testid="drives"
      onClose={close}
    >
      <header class="row middle apart gap-4">
        <h2 id="drives-title">{title}</h2>
        <Button kind="plain" icon={RefreshCw} testId="drives-again" onPress={found.reload}>
          {texts.value.exchange.lookAgain}
        </Button>
      </header>
      <Loaded of={found} empty={<NoDrive />}>
        {(drives) =>
          request.kind === "open" ? (
            <FileChoice {...request} drives={drives} action={action} />
          ) : (
            <DriveChoice {...request} drives={drives} action={action} />
          )
        }
      </Loaded>
      <FaultLine fault={action.fault} />
      <div class="button-row">
        <Button kind="plain" icon={X} testId="drives-close" onPress={close}>
          {labels.close}
        </Button>
      </div>
    </dialog>
  );
}

function NoDrive() {
  const labels = texts.value.exchange;
  return (
    <p>
      <strong>{labels.nowhere}</strong> {texts.value.kiosk.nowhereHint}
    </p>
  );
}

interface ChoiceProps {
  drives: readonly Drive[];
  /** Shows errors in the dialog, which covers the error line of the page. */
  action: ReturnType<typeof useAction>;
}

interface FileChoiceProps extends ChoiceProps {
  suffix: DriveFileSuffix;
  onFile(file: File): unknown;
}

function FileChoice({ drives, action, suffix, onFile }: FileChoiceProps) {
  const { kiosk: labels } = texts.value;
  const open = async ({ path, name }: DriveFile) => {
    const content = await kioskApi.driveFile(path, suffix);
    close();
    void settled(onFile(new File([content], name)));
  };
  return (
    <>
      {drives.map((drive) => (
        <section key={drive.path} class="column gap-2">
          <h3 class="row middle gap-2">
            <DriveName drive={drive} />
          </h3>
          {drive.files.length === 0 && <p>{labels.noFiles({ suffix })}</p>}
          {drive.files.map((file) => (
            <Button
              key={file.path}
              icon={FileText}
              class="drives__file"
              testId="drive-file"
              busy={action.busy}
              onPress={() => action.act(() => open(file))}
            >
              <span class="drives__name">{file.name}</span>
              <span class="drives__about">{aboutFile(file)}</span>
            </Button>
          ))}
        </section>
      ))}
    </>
  );
}

function aboutFile({ size_bytes, modified_at }: DriveFile): string {
  return texts.value.exchange.file({
    size: size(size_bytes, language.value),
    when: relativeTime(modified_at, new Date(), language.value, texts.value),
  });
}

function DriveName({ drive: { name, is_removable } }: { drive: Drive }) {
  const labels = texts.value.exchange;
  const Icon = is_removable ? Usb : HardDrive;
  return (
    <>
      <Icon class="icon" aria-hidden="true" />
      {is_removable ? labels.stick({ name }) : labels.folder({ name })}
    </>
  );
}

interface DriveChoiceProps extends ChoiceProps {
  name: string;
  content: Blob;
}

function DriveChoice({ drives, action, name, content }: DriveChoiceProps) {
  const saved = useSignal<SavedDriveFile | null>(null);
  const writable = drives.filter((drive) => drive.is_writable);
  const labels = texts.value.exchange;
  const save = async (drive: Drive) => {
    saved.value = null;
    saved.value = await kioskApi.saveOnDrive(drive.path, name, content);
  };
  if (writable.length === 0) return <NoDrive />;
  return (
    <>
      <div class="button-row">
        {writable.map((drive) => (
          <Button
            key={drive.path}
            icon={Save}
            testId="drive-save"
            busy={action.busy}
            onPress={() => action.act(() => save(drive))}
          >
            {labels.saveIn({ folder: drive.name })}
          </Button>
        ))}
      </div>
      <p role="status">{saved.value && savedText(saved.value)}</p>
    </>
  );
}

function savedText({ name, drive, is_removable }: SavedDriveFile): string {
  const saved = texts.value.kiosk.saved({ name, drive });
  return is_removable ? `${saved} ${texts.value.exchange.takeOut}` : saved;
}
