; The installer for Windows, for one person and without administrator's rights (docs/windows.md). package/windows.cmake runs
; makensis in the build folder with these definitions:
;   VERSION, VERSION4  0.1.0 and 0.1.0.0
;   OUT                the installer to write
;   LISTS              the folder with install.nsh and remove.nsh, which list each file (installed_files.cmake)
;   LICENCE, ICON      the page of the licence, the icon
;   SIDE               the picture beside the last page, 164 by 314 pixels
; Options: /S installs without questions, /D=FOLDER (the last one, without quotes) chooses the folder. Exit status: 0 done,
; 1 cancelled, 2 a file cannot be written or the folder is refused, 3 Moltact is open.
Target amd64-unicode
SetCompressor /SOLID lzma
RequestExecutionLevel user
ManifestDPIAware true
ManifestLongPathAware true
AllowSkipFiles off

!include MUI2.nsh
!include FileFunc.nsh
!include LogicLib.nsh
!include WinVer.nsh

!define CLASSES "Software\Classes"
!define ENTRY "Software\Microsoft\Windows\CurrentVersion\Uninstall\Moltact"
; Windows 10 1903: earlier ones give the program file names in another encoding than UTF-8.
!define OLDEST_BUILD 18362

Name "Moltact"
OutFile "${OUT}"
BrandingText "Moltact ${VERSION}"
InstallDir "$LOCALAPPDATA\Programs\Moltact"
InstallDirRegKey HKCU "${ENTRY}" "InstallLocation"

!define MUI_ICON "${ICON}"
!define MUI_UNICON "${ICON}"
!define MUI_WELCOMEFINISHPAGE_BITMAP "${SIDE}"
!define MUI_COMPONENTSPAGE_SMALLDESC
!define MUI_ABORTWARNING
!insertmacro MUI_PAGE_LICENSE "${LICENCE}"
!define MUI_PAGE_CUSTOMFUNCTION_LEAVE leaveFolder
!insertmacro MUI_PAGE_DIRECTORY
!insertmacro MUI_PAGE_INSTFILES
!define MUI_FINISHPAGE_RUN "$INSTDIR\moltact.exe"
!insertmacro MUI_PAGE_FINISH
!insertmacro MUI_UNPAGE_CONFIRM
!insertmacro MUI_UNPAGE_COMPONENTS
!insertmacro MUI_UNPAGE_INSTFILES
!insertmacro MUI_LANGUAGE "English"
!insertmacro MUI_LANGUAGE "German"

LangString open ${LANG_ENGLISH} "Moltact is open, or its files in $INSTDIR cannot be written. Close Moltact and try again."
LangString open ${LANG_GERMAN} "Moltact ist geöffnet, oder seine Dateien in $INSTDIR sind nicht schreibbar. Moltact schließen und erneut versuchen."
LangString oldWindows ${LANG_ENGLISH} "Moltact needs Windows 10 (version 1903) or later."
LangString oldWindows ${LANG_GERMAN} "Moltact benötigt Windows 10 (Version 1903) oder neuer."
LangString workFolder ${LANG_ENGLISH} "Moltact keeps your results in this folder. Choose another one for the program."
LangString workFolder ${LANG_GERMAN} "In diesem Ordner bewahrt Moltact Ihre Ergebnisse auf. Einen anderen für das Programm wählen."
LangString notRemoved ${LANG_ENGLISH} "The Moltact in $R0 cannot be removed. Close it, or uninstall it first."
LangString notRemoved ${LANG_GERMAN} "Das Moltact in $R0 lässt sich nicht entfernen. Es schließen oder zuerst deinstallieren."
LangString pack ${LANG_ENGLISH} "Moltact lesson pack"
LangString pack ${LANG_GERMAN} "Moltact-Lektion, gepackt"
LangString recording ${LANG_ENGLISH} "Moltact recording of a hand"
LangString recording ${LANG_GERMAN} "Moltact-Aufnahme einer Hand"
LangString program ${LANG_ENGLISH} "The program"
LangString program ${LANG_GERMAN} "Das Programm"
LangString work ${LANG_ENGLISH} "Your work and settings too"
LangString work ${LANG_GERMAN} "Auch Ihre Arbeit und Einstellungen"
LangString aboutProgram ${LANG_ENGLISH} "Removes what was installed. Other files in the folder remain."
LangString aboutProgram ${LANG_GERMAN} "Entfernt, was installiert wurde. Andere Dateien im Ordner bleiben erhalten."
LangString aboutWork ${LANG_ENGLISH} "Deletes attempts, classes, own lessons, molecules and settings for good."
LangString aboutWork ${LANG_GERMAN} "Löscht Versuche, Klassen, eigene Lektionen, Moleküle und Einstellungen endgültig."

VIProductVersion "${VERSION4}"
VIFileVersion "${VERSION4}"
!macro VersionText language description
  VIAddVersionKey /LANG=${language} ProductName "Moltact"
  VIAddVersionKey /LANG=${language} FileDescription "${description}"
  VIAddVersionKey /LANG=${language} FileVersion "${VERSION}"
  VIAddVersionKey /LANG=${language} ProductVersion "${VERSION}"
  VIAddVersionKey /LANG=${language} CompanyName "The Moltact authors"
  VIAddVersionKey /LANG=${language} LegalCopyright "The Moltact authors; MIT License"
!macroend
!insertmacro VersionText ${LANG_ENGLISH} "Installer of Moltact"
!insertmacro VersionText ${LANG_GERMAN} "Installationsprogramm von Moltact"

; A program that runs cannot be opened for writing.
!macro EndUnlessClosed
  ${Do}
    StrCpy $R9 ""
    ${ForEach} $R8 1 2 + 1
      StrCpy $R7 "$INSTDIR\moltact.exe"
      ${IfThen} $R8 = 2 ${|} StrCpy $R7 "$INSTDIR\moltact-bench.exe" ${|}
      ${If} ${FileExists} "$R7"
        ClearErrors
        FileOpen $R6 "$R7" a
        ${If} ${Errors}
          StrCpy $R9 open
        ${Else}
          FileClose $R6
        ${EndIf}
      ${EndIf}
    ${Next}
    ${IfThen} $R9 == "" ${|} ${ExitDo} ${|}
    MessageBox MB_RETRYCANCEL|MB_ICONEXCLAMATION "$(open)" /SD IDCANCEL IDRETRY +3
    SetErrorLevel 3
    Quit
  ${Loop}
!macroend

!macro TellWindows
  System::Call 'shell32::SHChangeNotify(i 0x08000000, i 0, p 0, p 0)'  ; SHCNE_ASSOCCHANGED
!macroend

Function .onInit
  ${IfNot} ${AtLeastBuild} ${OLDEST_BUILD}
    MessageBox MB_OK|MB_ICONSTOP "$(oldWindows)" /SD IDOK
    SetErrorLevel 2
    Quit
  ${EndIf}
FunctionEnd

; $LOCALAPPDATA\moltact is for the person's work, in folders with the same names as the program's.
!macro RefuseWorkFolder otherwise
  GetFullPathName $R0 "$INSTDIR"
  ${If} $R0 == "$LOCALAPPDATA\moltact"
  ${OrIf} $R0 == "$APPDATA\moltact"
    MessageBox MB_OK|MB_ICONSTOP "$(workFolder)" /SD IDOK
    ${otherwise}
  ${EndIf}
!macroend

Function leaveFolder
  !insertmacro RefuseWorkFolder Abort
FunctionEnd

; $R0: a folder. Removes the Moltact that was installed there; the person's work stays.
Function removeEarlier
  ${IfThen} $R0 == "" ${|} Return ${|}
  ${IfNot} ${FileExists} "$R0\uninstall.exe"
    Return
  ${EndIf}
  CopyFiles /SILENT "$R0\uninstall.exe" "$PLUGINSDIR\earlier.exe"
  ExecWait '"$PLUGINSDIR\earlier.exe" /S _?=$R0' $R1
  Delete "$PLUGINSDIR\earlier.exe"
  ${If} $R1 != 0
    MessageBox MB_OK|MB_ICONSTOP "$(notRemoved)" /SD IDOK
    SetErrorLevel 3
    Quit
  ${EndIf}
  ; Run in this way, it leaves itself behind.
  Delete "$R0\uninstall.exe"
  RMDir "$R0"
FunctionEnd

Section
  SetShellVarContext current
  InitPluginsDir
  !insertmacro RefuseWorkFolder "Abort"
  !insertmacro EndUnlessClosed
  ReadRegStr $R0 HKCU "${ENTRY}" "InstallLocation"
  Call removeEarlier
  StrCpy $R0 $INSTDIR
  Call removeEarlier

  !include "${LISTS}/install.nsh"
  SetOutPath "$INSTDIR"
  WriteUninstaller "$INSTDIR\uninstall.exe"
  CreateShortcut "$SMPROGRAMS\Moltact.lnk" "$INSTDIR\moltact.exe"

  WriteRegStr HKCU "${CLASSES}\.moltact" "" "Moltact.Pack"
  WriteRegStr HKCU "${CLASSES}\Moltact.Pack" "" "$(pack)"
  WriteRegStr HKCU "${CLASSES}\Moltact.Pack\DefaultIcon" "" "$INSTDIR\moltact.exe,0"
  WriteRegStr HKCU "${CLASSES}\Moltact.Pack\shell\open\command" "" '"$INSTDIR\moltact.exe" "%1"'
  ; In the list "Open with" of these types; their default programs stay.
  WriteRegStr HKCU "${CLASSES}\.recording\OpenWithProgids" "Moltact.Recording" ""
  WriteRegStr HKCU "${CLASSES}\Moltact.Recording" "" "$(recording)"
  WriteRegStr HKCU "${CLASSES}\Moltact.Recording\DefaultIcon" "" "$INSTDIR\moltact.exe,0"
  WriteRegStr HKCU "${CLASSES}\Moltact.Recording\shell\open\command" "" '"$INSTDIR\moltact.exe" "%1"'
  WriteRegStr HKCU "${CLASSES}\Applications\moltact.exe" "FriendlyAppName" "Moltact"
  WriteRegStr HKCU "${CLASSES}\Applications\moltact.exe\shell\open\command" "" '"$INSTDIR\moltact.exe" "%1"'
  !macro Opens ending
    WriteRegStr HKCU "${CLASSES}\Applications\moltact.exe\SupportedTypes" ".${ending}" ""
  !macroend
  !insertmacro Opens md
  !insertmacro Opens pdb
  !insertmacro Opens ent
  !insertmacro Opens cif
  !insertmacro Opens mmcif
  !insertmacro Opens sdf
  !insertmacro Opens mol
  !insertmacro Opens mol2
  !insertmacro Opens pdbqt
  !insertmacro Opens pqr
  !insertmacro Opens gro
  !insertmacro Opens xyzr

  WriteRegStr HKCU "${ENTRY}" "DisplayName" "Moltact"
  WriteRegStr HKCU "${ENTRY}" "DisplayVersion" "${VERSION}"
  WriteRegStr HKCU "${ENTRY}" "DisplayIcon" "$INSTDIR\moltact.exe,0"
  WriteRegStr HKCU "${ENTRY}" "Publisher" "The Moltact authors"
  WriteRegStr HKCU "${ENTRY}" "InstallLocation" "$INSTDIR"
  WriteRegStr HKCU "${ENTRY}" "UninstallString" '"$INSTDIR\uninstall.exe"'
  WriteRegStr HKCU "${ENTRY}" "QuietUninstallString" '"$INSTDIR\uninstall.exe" /S'
  WriteRegDWORD HKCU "${ENTRY}" "NoModify" 1
  WriteRegDWORD HKCU "${ENTRY}" "NoRepair" 1
  ${GetSize} "$INSTDIR" "/S=0K" $0 $1 $2
  WriteRegDWORD HKCU "${ENTRY}" "EstimatedSize" $0
  !insertmacro TellWindows
SectionEnd

Section "un.$(program)" removeProgram
  SectionIn RO
  SetShellVarContext current
  !insertmacro EndUnlessClosed
  SetOutPath "$TEMP"  ; the working folder cannot be removed
  !include "${LISTS}/remove.nsh"
  Delete "$INSTDIR\uninstall.exe"
  RMDir "$INSTDIR"
  Delete "$SMPROGRAMS\Moltact.lnk"
  RMDir /r "$TEMP\moltact"  ; pictures of lessons and results of calculations, which the program makes again

  ReadRegStr $0 HKCU "${CLASSES}\.moltact" ""
  ${If} $0 == "Moltact.Pack"
    DeleteRegValue HKCU "${CLASSES}\.moltact" ""
  ${EndIf}
  DeleteRegKey /ifempty HKCU "${CLASSES}\.moltact"
  DeleteRegKey HKCU "${CLASSES}\Moltact.Pack"
  DeleteRegValue HKCU "${CLASSES}\.recording\OpenWithProgids" "Moltact.Recording"
  DeleteRegKey /ifempty HKCU "${CLASSES}\.recording\OpenWithProgids"
  DeleteRegKey /ifempty HKCU "${CLASSES}\.recording"
  DeleteRegKey HKCU "${CLASSES}\Moltact.Recording"
  DeleteRegKey HKCU "${CLASSES}\Applications\moltact.exe"
  DeleteRegKey HKCU "${ENTRY}"
  !insertmacro TellWindows
SectionEnd

Section /o "un.$(work)" removeWork
  RMDir /r "$LOCALAPPDATA\moltact"
  RMDir /r "$APPDATA\moltact"
SectionEnd

; For schools: uninstall.exe /S /DELETEWORK
Function un.onInit
  ${GetParameters} $0
  ClearErrors
  ${GetOptions} $0 "/DELETEWORK" $1
  ${IfNot} ${Errors}
    !insertmacro SelectSection ${removeWork}
  ${EndIf}
FunctionEnd

!insertmacro MUI_UNFUNCTION_DESCRIPTION_BEGIN
  !insertmacro MUI_DESCRIPTION_TEXT ${removeProgram} "$(aboutProgram)"
  !insertmacro MUI_DESCRIPTION_TEXT ${removeWork} "$(aboutWork)"
!insertmacro MUI_UNFUNCTION_DESCRIPTION_END
