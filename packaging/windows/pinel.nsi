; The installer of PINEL Desktop for Windows, compiled by packaging/nsis.py, which defines:
;   VERSION   three numbers, such as 0.2.0
;   FOLDER    the folder of the packaged program
;   SIZE_KIB  size of its files
;   ICON      an icon file
;   PICTURE   a bitmap of 164 x 314 pixels
;   OUTPUT    the installer to write
;
; Options: /S without a window, /AllUsers or /CurrentUser, and last /D=FOLDER, without quotation marks even if it has spaces.
; Without a window, its only message is in %TEMP%\pinel-setup.log.
; Exit status: 0 done, 1 cancelled, 2 failed, 3 a newer version is installed, 4 PINEL is open, 5 no rights for all accounts,
; 6 Windows is too old, 7 done, but pinel.toml has faults.

; an installer for 32 bits can install nothing where Windows runs only programs of 64 bits
Target amd64-unicode
SetCompressor /SOLID lzma
; the same files give the same bytes
SetDateSave off
ManifestDPIAware true

!define UNINSTALL_KEY "Software\Microsoft\Windows\CurrentVersion\Uninstall\PINEL"
!define APP_PATHS_KEY "Software\Microsoft\Windows\CurrentVersion\App Paths"
!define FILE_TYPE "PINEL.Work"
!define WEBVIEW2_KEY "Microsoft\EdgeUpdate\Clients\{F3017226-FE2A-4295-8BDF-00C3A9A7E4C5}"
!define WEBVIEW2_SETUP "MicrosoftEdgeWebView2RuntimeInstallerX64.exe"

!define STATUS_NEWER 3
!define STATUS_OPEN 4
!define STATUS_NO_RIGHTS 5
!define STATUS_OLD_WINDOWS 6
!define STATUS_SETUP_FILE 7

!define MULTIUSER_EXECUTIONLEVEL Highest
!define MULTIUSER_MUI
!define MULTIUSER_INSTALLMODE_COMMANDLINE
!define MULTIUSER_USE_PROGRAMFILES64
!define MULTIUSER_INSTALLMODE_INSTDIR "PINEL"
!define MULTIUSER_INSTALLMODE_INSTDIR_REGISTRY_KEY "${UNINSTALL_KEY}"
!define MULTIUSER_INSTALLMODE_INSTDIR_REGISTRY_VALUENAME "InstallLocation"
!define MULTIUSER_INSTALLMODE_DEFAULT_REGISTRY_KEY "${UNINSTALL_KEY}"
!define MULTIUSER_INSTALLMODE_DEFAULT_REGISTRY_VALUENAME "InstallLocation"

!include MultiUser.nsh
!include MUI2.nsh
!include FileFunc.nsh
!include LogicLib.nsh
!include WinVer.nsh
!include WordFunc.nsh

Name "PINEL Desktop"
OutFile "${OUTPUT}"
BrandingText "PINEL Desktop ${VERSION}"
VIProductVersion "${VERSION}.0"
VIAddVersionKey ProductName "PINEL Desktop"
VIAddVersionKey ProductVersion "${VERSION}"
VIAddVersionKey FileVersion "${VERSION}"
VIAddVersionKey FileDescription "PINEL Desktop"
VIAddVersionKey LegalCopyright "PINEL Desktop contributors"

!define MUI_ICON "${ICON}"
!define MUI_UNICON "${ICON}"
!define MUI_WELCOMEFINISHPAGE_BITMAP "${PICTURE}"
!define MUI_ABORTWARNING
!insertmacro MULTIUSER_PAGE_INSTALLMODE
!insertmacro MUI_PAGE_DIRECTORY
!insertmacro MUI_PAGE_INSTFILES
!define MUI_FINISHPAGE_RUN
!define MUI_FINISHPAGE_RUN_FUNCTION OpenProgram
!insertmacro MUI_PAGE_FINISH
!insertmacro MUI_UNPAGE_CONFIRM
!insertmacro MUI_UNPAGE_INSTFILES
!insertmacro MUI_LANGUAGE PortugueseBR
!insertmacro MUI_LANGUAGE English
!insertmacro MUI_LANGUAGE Spanish
!insertmacro MUI_LANGUAGE French
!include texts.nsh

; The installed version's folder and number, "" without one.
Var FormerFolder
Var FormerVersion
; What /D names, "" without it.
Var ChosenFolder

; Shows a message, or writes it to the log.
!macro Report TEXT
  Push "${TEXT}"
  !ifdef __UNINSTALL__
    Call un.Report
  !else
    Call Report
  !endif
!macroend

; Reports why nothing is done, and ends with a status.
!macro Refuse STATUS TEXT
  !insertmacro Report "${TEXT}"
  SetErrorLevel ${STATUS}
  Quit
!macroend

; Refuses /AllUsers of somebody who may not install for all accounts. MultiUser.nsh would open a window even with /S.
!macro RefuseWithoutRights
  ${GetParameters} $R0
  ClearErrors
  ${GetOptions} $R0 "/AllUsers" $R1
  ${IfNot} ${Errors}
    UserInfo::GetAccountType
    Pop $R1
    ${If} $R1 != "Admin"
      !insertmacro Refuse ${STATUS_NO_RIGHTS} "$(NO_RIGHTS)"
    ${EndIf}
  ${EndIf}
!macroend

; Waits until a person has closed the PINEL of a folder; refuses if nobody can be asked. Windows opens the file of a running
; program for nobody who wants to write.
!macro RefuseIfOpen FOLDER
  ${Do}
    StrCpy $R1 ""
    !insertmacro FindOpenProgram "${FOLDER}\pinel-desktop.exe"
    !insertmacro FindOpenProgram "${FOLDER}\pinel.exe"
    ${If} $R1 == ""
      ${Break}
    ${EndIf}
    ${If} ${Silent}
      !insertmacro Refuse ${STATUS_OPEN} "$(IS_OPEN)"
    ${EndIf}
    ${If} ${Cmd} `MessageBox MB_RETRYCANCEL|MB_ICONEXCLAMATION "$(IS_OPEN)" IDCANCEL`
      SetErrorLevel ${STATUS_OPEN}
      Quit
    ${EndIf}
  ${Loop}
!macroend

; Sets $R1 if the file cannot be opened for writing.
!macro FindOpenProgram FILE
  ${If} ${FileExists} "${FILE}"
    ClearErrors
    FileOpen $R0 "${FILE}" a
    ${If} ${Errors}
      StrCpy $R1 "open"
    ${Else}
      FileClose $R0
    ${EndIf}
  ${EndIf}
!macroend

; Deletes the program's files in a folder, which may hold files of others.
!macro RemoveProgram FOLDER
  RMDir /r "${FOLDER}\_internal"
  Delete "${FOLDER}\pinel.exe"
  Delete "${FOLDER}\pinel-desktop.exe"
  Delete "${FOLDER}\THIRD-PARTY-NOTICES.txt"
  Delete "${FOLDER}\pinel-desktop.cdx.json"
  Delete "${FOLDER}\uninstall.exe"
!macroend

!macro ReportFunction PREFIX
Function ${PREFIX}Report
  Exch $R0
  ${If} ${Silent}
    FileOpen $R1 "$TEMP\pinel-setup.log" w
    FileWriteUTF16LE /BOM $R1 "$R0$\r$\n"
    FileClose $R1
  ${Else}
    MessageBox MB_OK|MB_ICONINFORMATION "$R0"
  ${EndIf}
  Pop $R0
FunctionEnd
!macroend
!insertmacro ReportFunction ""
!insertmacro ReportFunction "un."

Function .onInit
  Delete "$TEMP\pinel-setup.log"
  ${IfNot} ${AtLeastWin10}
    !insertmacro Refuse ${STATUS_OLD_WINDOWS} "$(OLD_WINDOWS)"
  ${EndIf}
  !insertmacro RefuseWithoutRights
  ; MultiUser.nsh replaces the folder of /D
  StrCpy $ChosenFolder $INSTDIR
  !insertmacro MULTIUSER_INIT
  ${If} $ChosenFolder != ""
    StrCpy $INSTDIR $ChosenFolder
  ${EndIf}
FunctionEnd

Function un.onInit
  Delete "$TEMP\pinel-setup.log"
  !insertmacro RefuseWithoutRights
  !insertmacro MULTIUSER_UNINIT
FunctionEnd

; The installer may be the administrator's; PINEL must be the person's, as from the Start menu.
Function OpenProgram
  Exec '"$WINDIR\explorer.exe" "$INSTDIR\pinel-desktop.exe"'
FunctionEnd

; Sets $R0 to the version of WebView2, "" without one.
Function FindWebView2
  ReadRegStr $R0 HKLM "SOFTWARE\WOW6432Node\${WEBVIEW2_KEY}" "pv"
  ${If} $R0 == ""
  ${OrIf} $R0 == "0.0.0.0"
    ReadRegStr $R0 HKCU "Software\${WEBVIEW2_KEY}" "pv"
  ${EndIf}
  ${If} $R0 == "0.0.0.0"
    StrCpy $R0 ""
  ${EndIf}
FunctionEnd

Section "-Checks"
  ReadRegStr $FormerFolder SHCTX "${UNINSTALL_KEY}" "InstallLocation"
  ReadRegStr $FormerVersion SHCTX "${UNINSTALL_KEY}" "DisplayVersion"
  ${If} $FormerVersion != ""
    ${VersionCompare} "$FormerVersion" "${VERSION}" $R0
    ${If} $R0 == 1
      !insertmacro Refuse ${STATUS_NEWER} "$(NEWER)"
    ${EndIf}
    !insertmacro RefuseIfOpen "$FormerFolder"
  ${EndIf}
  !insertmacro RefuseIfOpen "$INSTDIR"
SectionEnd

Section "-Program"
  ${If} $FormerFolder != ""
    !insertmacro RemoveProgram "$FormerFolder"
  ${EndIf}
  !insertmacro RemoveProgram "$INSTDIR"
  SetOutPath "$INSTDIR"
  File /r "${FOLDER}/*.*"
  WriteUninstaller "$INSTDIR\uninstall.exe"

  WriteRegStr SHCTX "${UNINSTALL_KEY}" "DisplayName" "PINEL Desktop"
  WriteRegStr SHCTX "${UNINSTALL_KEY}" "DisplayVersion" "${VERSION}"
  WriteRegStr SHCTX "${UNINSTALL_KEY}" "Publisher" "PINEL Desktop contributors"
  WriteRegStr SHCTX "${UNINSTALL_KEY}" "DisplayIcon" "$INSTDIR\pinel-desktop.exe"
  WriteRegStr SHCTX "${UNINSTALL_KEY}" "InstallLocation" "$INSTDIR"
  WriteRegStr SHCTX "${UNINSTALL_KEY}" "UninstallString" '"$INSTDIR\uninstall.exe" /$MultiUser.InstallMode'
  WriteRegStr SHCTX "${UNINSTALL_KEY}" "QuietUninstallString" '"$INSTDIR\uninstall.exe" /$MultiUser.InstallMode /S'
  WriteRegDWORD SHCTX "${UNINSTALL_KEY}" "EstimatedSize" ${SIZE_KIB}
  WriteRegDWORD SHCTX "${UNINSTALL_KEY}" "NoModify" 1
  WriteRegDWORD SHCTX "${UNINSTALL_KEY}" "NoRepair" 1
SectionEnd

Section "-Entries"
  ; by which Windows+R and `start pinel` find the programs
  WriteRegStr SHCTX "${APP_PATHS_KEY}\pinel.exe" "" "$INSTDIR\pinel.exe"
  WriteRegStr SHCTX "${APP_PATHS_KEY}\pinel-desktop.exe" "" "$INSTDIR\pinel-desktop.exe"

  ; A double click opens PINEL; the teacher chooses there what to bring in from the file.
  WriteRegStr SHCTX "Software\Classes\.pinel" "" "${FILE_TYPE}"
  WriteRegStr SHCTX "Software\Classes\${FILE_TYPE}" "" "$(FILE_TYPE_NAME)"
  WriteRegStr SHCTX "Software\Classes\${FILE_TYPE}\DefaultIcon" "" "$INSTDIR\pinel-desktop.exe,0"
  WriteRegStr SHCTX "Software\Classes\${FILE_TYPE}\shell\open\command" "" '"$INSTDIR\pinel-desktop.exe" "%1"'
  ${RefreshShellIcons}

  RMDir /r "$SMPROGRAMS\PINEL"
  CreateDirectory "$SMPROGRAMS\PINEL"
  SetOutPath "$INSTDIR"
  CreateShortcut "$SMPROGRAMS\PINEL\PINEL.lnk" "$INSTDIR\pinel-desktop.exe"
  CreateShortcut "$SMPROGRAMS\PINEL\$(CONSOLE_NAME).lnk" "$SYSDIR\cmd.exe" '/k "set "PATH=$INSTDIR;%PATH%" & pinel --help"' \
    "$INSTDIR\pinel.exe"
SectionEnd

Section "-WebView2"
  Call FindWebView2
  ${If} $R0 == ""
  ${AndIf} ${FileExists} "$EXEDIR\${WEBVIEW2_SETUP}"
    DetailPrint "$(INSTALLING_WEBVIEW2)"
    ExecWait '"$EXEDIR\${WEBVIEW2_SETUP}" /silent /install'
    Call FindWebView2
  ${EndIf}
  ${If} $R0 == ""
    !insertmacro Report "$(NO_WEBVIEW2)"
  ${EndIf}
SectionEnd

Section "-SetupFile"
  ${If} ${FileExists} "$EXEDIR\pinel.toml"
    RMDir /r "$INSTDIR\setup"
    CreateDirectory "$INSTDIR\setup"
    CopyFiles /SILENT "$EXEDIR\pinel.toml" "$INSTDIR\setup"
    ${If} ${FileExists} "$EXEDIR\*.pinel"
      CopyFiles /SILENT "$EXEDIR\*.pinel" "$INSTDIR\setup"
    ${EndIf}
    nsExec::Exec '"$INSTDIR\pinel.exe" setup --check "$INSTDIR\setup\pinel.toml"'
    Pop $R0
    ${If} $R0 != 0
      !insertmacro Report "$(SETUP_FILE_FAULTS)"
      SetErrorLevel ${STATUS_SETUP_FILE}
    ${EndIf}
  ${EndIf}
SectionEnd

Section "Uninstall"
  !insertmacro RefuseIfOpen "$INSTDIR"
  !insertmacro RemoveProgram "$INSTDIR"
  RMDir /r "$INSTDIR\setup"
  RMDir "$INSTDIR"
  RMDir /r "$SMPROGRAMS\PINEL"
  DeleteRegKey SHCTX "${APP_PATHS_KEY}\pinel.exe"
  DeleteRegKey SHCTX "${APP_PATHS_KEY}\pinel-desktop.exe"
  DeleteRegKey SHCTX "Software\Classes\${FILE_TYPE}"
  ReadRegStr $R0 SHCTX "Software\Classes\.pinel" ""
  ${If} $R0 == "${FILE_TYPE}"
    DeleteRegKey SHCTX "Software\Classes\.pinel"
  ${EndIf}
  DeleteRegKey SHCTX "${UNINSTALL_KEY}"
  ${RefreshShellIcons}
  SetShellVarContext current
  !insertmacro Report "$(WORK_STAYS)"
SectionEnd
